// Scales: round numbers, the range that a view calls for, and the legend of false colours.

/** Mantissas of round ends of a range, and of the steps between numbers of a legend. */
const ENDS = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];
const STEPS = [1, 2, 5, 10];

/** Least number of a scale of equal ratios over the greatest, where it is chosen. */
const DEEPEST = 1e-4;

const powerBelow = (x) => 10 ** Math.floor(Math.log10(x));

/** The least round number that is not below `x`; 1 for zero. */
function roundAbove(x) {
  if (!(x > 0)) return 1;
  const power = powerBelow(x);
  return power * (ENDS.find((end) => end * power >= x * (1 - 1e-12)) ?? x / power);
}

/** The greatest round number that is not above `x` > 0. */
function roundBelow(x) {
  const power = powerBelow(x);
  return power * (ENDS.findLast((end) => end * power <= x * (1 + 1e-12)) ?? x / power);
}

/** A range for numbers of which most lie between `low` and `high`. */
function rangeFor([low, high], isLog) {
  const highest = roundAbove(high);
  if (!isLog) return [0, highest];
  const lowest = roundBelow(Math.max(low, DEEPEST * highest));
  return [lowest < highest ? lowest : 0.1 * highest, highest];
}

/** Round numbers over a range: in equal steps, or in equal ratios. */
function ticks([low, high], isLog) {
  if (isLog && high >= 8 * low) {
    const powers = [];
    for (let power = powerBelow(low); power <= high; power *= 10) powers.push(power);
    const mantissas = powers.length > 4 ? [1] : powers.length > 2 ? [1, 2, 5] : [1, 2, 3, 5, 7];
    const all = powers.flatMap((power) => mantissas.map((mantissa) => mantissa * power));
    return all.filter((x) => x >= low * (1 - 1e-9) && x <= high * (1 + 1e-9));
  }
  const power = powerBelow((high - low) / 8);
  const step = power * STEPS.find((mantissa) => (high - low) / (mantissa * power) <= 8 + 1e-6);
  const first = Math.ceil(low / step - 1e-6);
  return Array.from({ length: Math.floor(high / step + 1e-6) - first + 1 }, (_, k) => (first + k) * step);
}

/** A number with so many digits, without zeros at its end. */
function digits(x, count) {
  const text = Number(x.toPrecision(count));
  return text !== 0 && (Math.abs(text) < 1e-4 || Math.abs(text) >= 1e7) ? text.toExponential() : `${text}`;
}

/** The part of a scale that a number takes, from 0 to 1. */
function placeOnScale(x, [low, high], isLog) {
  return clamp(isLog ? Math.log(Math.max(x, low) / low) / Math.log(high / low) : (x - low) / (high - low), 0, 1);
}

/** The percentiles `parts` (from 0 to 1) of numbers. */
function percentiles(numbers, parts) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return parts.map((part) => sorted[Math.floor((sorted.length - 1) * part)]);
}

/** Draws the legend into its element. */
function drawLegend(element, { lines, range, isLog, gradient }) {
  element.querySelector("figcaption").replaceChildren(
    ...lines.map((line) => Object.assign(document.createElement("div"), { textContent: line })),
  );
  const bar = element.querySelector("canvas");
  [bar.width, bar.height] = [1, gradient.length];
  const pen = bar.getContext("2d");
  gradient.forEach(([red, green, blue], k) => {
    pen.fillStyle = `rgb(${red} ${green} ${blue})`;
    pen.fillRect(0, gradient.length - 1 - k, 1, 1);
  });
  const marks = ticks(range, isLog).map((x) => {
    const mark = Object.assign(document.createElement("span"), { textContent: digits(x, 6) });
    mark.style.bottom = `${100 * placeOnScale(x, range, isLog)}%`;
    return mark;
  });
  element.querySelector(".ticks").replaceChildren(...marks);
}
