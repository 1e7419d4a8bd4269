import pandas

rows = pandas.read_json("runs/mine/rows.jsonl", lines=True)
print(rows.groupby(["solver", "verdict"]).size())
print(pandas.read_csv("runs/mine/table.csv")[["solver", "success", "time_median_ms"]])
