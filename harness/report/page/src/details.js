// All that is known of one row, and the command that solves it again.

import { element } from "./dom.js";
import { duration, figure, tolerance } from "./numbers.js";
import { verdictSigns } from "./verdicts.js";

const residualMeanings = {
  residual: "natural residual max |min(z/s_z, w/s_w)|",
  residual_unscaled: "the same, unscaled",
  zero_residual: "natural residual of z = 0",
  paper_error: "paper's error |w - M z - q - z0 c|",
  min_z: "least z", min_w: "least w", max_zw: "largest |z w|",
  backward_error: "backward error of the basis",
};

export function commandLine(run, row, verb, flags = "") {
  const { command } = run.instances[row.instance];
  return assembled(run, row, command, verb, flags);
}

function assembled(run, row, command, verb, flags) {
  const judged = row.tolerance === 1e-6 ? "" : ` --tolerance ${tolerance(row.tolerance)}`;
  return `${command.before}${run.program} ${verb} ${command.where}${
    run.variants[row.variant].arguments}${judged}${flags}${command.after}`;
}

function commandBlock(label, name, words) {
  const code = element("code", { "data-command": name }, words);
  const copy = element("button", { type: "button", onclick: async () => {
    try {
      await navigator.clipboard.writeText(words);
      copy.textContent = "Copied";
    } catch {  // Not allowed here: selected, so that the keyboard can copy it.
      getSelection().selectAllChildren(code);
      copy.textContent = "Selected";
    }
    setTimeout(() => { copy.textContent = "Copy"; }, 1500);
  } }, "Copy");
  return element("div", { class: "command" }, element("span", {}, label), copy,
                 element("pre", { tabindex: 0 }, code));
}

function listOf(pairs) {
  return element("dl", {}, ...pairs.flatMap(([name, value]) =>
    [element("dt", {}, name), element("dd", {}, String(value))]));
}

function commands(run, row) {
  const { command, simulated } = run.instances[row.instance];
  const blocks = [commandBlock("Replay it", "replay", commandLine(run, row, "replay")),
                  commandBlock("Follow its pivots", "trace", commandLine(run, row, "solve", " --trace"))];
  if (command.note) blocks.push(element("p", { class: "note" }, command.note));
  if (simulated)
    blocks.push(commandBlock("Without the corpus", "simulated",
                             assembled(run, row, simulated, "solve", " --trace")),
                element("p", { class: "note" }, simulated.note));
  return blocks;
}

/** The panel of one judged row. */
export function details(run, judged) {
  const { row, verdict, column, unclaimed } = judged;
  const instance = run.instances[row.instance], variant = run.variants[row.variant];
  const facts = [
    ["verdict", `${verdict}: ${verdictSigns[verdict][1]}`],
    ...(verdict !== row.verdict ? [["verdict of the run", `${row.verdict}, at ${
      tolerance(row.tolerance)}`]] : []),
    ["claim", row.claim ?? "none: there was no answer to judge"],
    ["message", row.message || "none"],
    ...(unclaimed ? [["unclaimed", "z passes the check although a failure is claimed"]] : []),
    ...(column === "trivial" ? [["trivial", "z = 0 is a solution too"]] : []),
    ["time", row.median_ns === null ? "none" : row.samples > 1
      ? `${duration(row.median_ns)} median of ${row.samples} (${duration(row.least_ns)} to ${
          duration(row.most_ns)})` : `${duration(row.median_ns)}, one sample`],
    ...(row.signal ? [["ended by signal", row.signal]] : []),
    ["instance", `n = ${instance.n}, ${instance.contacts} contacts${
      instance.active === null ? "" : `, ${instance.active} active`}`],
    ["start", variant.start],
    ["sha256", instance.sha256],
    ["environment", `${row.environment}${row.jobs > 1 ? `, ${row.jobs} jobs at the same time` : ""}`],
  ];
  const residuals = row.accuracy
    ? Object.entries(row.accuracy).map(([name, value]) => [residualMeanings[name] ?? name,
                                                           figure(value)])
    : [["residuals", "none: no answer"]];
  const work = Object.entries(row.work).filter(([, count]) => count !== 0 && count !== null);
  return [
    element("h3", { tabindex: -1 }, `${variant.label} on ${instance.name}`),
    element("p", { class: `badge c-${column}` }, verdict),
    listOf(facts),
    ...(row.stderr ? [element("h4", {}, "What the worker wrote last"),
                      element("pre", { class: "stderr", tabindex: 0 }, row.stderr)] : []),
    element("h4", {}, "Commands, from the root of the repository"), ...commands(run, row),
    element("h4", {}, "Residuals"), listOf(residuals),
    element("h4", {}, "Work"),
    listOf(work.length ? work.map(([name, count]) => [name.replace(/_/g, " "), count])
                       : [["work", row.accuracy ? "nothing counted" : "unknown: no answer"]]),
    element("h4", {}, "Options"),
    listOf(Object.entries(variant.options ?? {}).map(([name, value]) => [name, value])),
  ];
}
