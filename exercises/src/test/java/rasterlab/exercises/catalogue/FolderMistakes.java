package rasterlab.exercises.catalogue;

import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.provider.Arguments;

/** Mistakes in the folder of an exercise, each with what is said of it. */
final class FolderMistakes {
    private FolderMistakes() {}

    /** Name of the mistake, file, text, what stands in its place, and words of the message. */
    static Stream<Arguments> all() {
        String json = "exercise.json";
        String cases = "cases.json";
        return Stream.of(
                argumentSet(
                        "picture that is not there",
                        "statement.ru.md",
                        "segment.svg",
                        "circle.svg",
                        "circle.svg: no such file to read"),
                argumentSet(
                        "picture from elsewhere",
                        "statement.en.md",
                        "(segment.svg)",
                        "(http://localhost/segment.svg)",
                        "statement.en.md: picture must lie in the exercise's own folder"),
                argumentSet(
                        "file that is no picture",
                        "statement.en.md",
                        "segment.svg",
                        "cases.json",
                        "picture must end in one of .png, .svg, got 'cases.json'"),
                argumentSet(
                        "picture of another form than its name tells",
                        "segment.svg",
                        "<svg",
                        "<html",
                        "'segment.svg' cannot be read as SVG"),
                argumentSet("file is no JSON", json, "{", "[", "exercise.json is not JSON: line"),
                argumentSet("array for object", cases, "[", "{} [", "cases.json is not JSON"),
                argumentSet(
                        "unknown topic",
                        json,
                        "\"line\"",
                        "\"lines\"",
                        "field 'topic' must be one of line, circle, ellipse, fill, "),
                argumentSet(
                        "contract that is no part of the topic",
                        json,
                        "\"topic\"",
                        "\"contract\": \"CurveFlattener\", \"topic\"",
                        "field 'contract' must be one of WindowedLineRasterizer, got 'CurveFlattener'"),
                argumentSet(
                        "unknown property",
                        cases,
                        "\"reversal\"",
                        "\"reverse\"",
                        "field 'property', field 'holds' must be one of reversal, translation, octant-symmetry, got 'reverse'"),
                argumentSet(
                        "property without a number of inputs",
                        cases,
                        "\"shape\": \"any\", \"count\": 8, \"seed\": 1,",
                        "\"shape\": \"any\", \"seed\": 1,",
                        "field 'count' is missing"),
                argumentSet(
                        "property that is open without a seed",
                        cases,
                        "\"count\": 8, \"seed\": 1,",
                        "\"count\": 8,",
                        "field 'visibility' must not be open where the property has no 'seed'"),
                argumentSet(
                        "property on inputs that it says nothing of",
                        cases,
                        "\"along\": \"=2*half+1\", \"across\": \"0..along\"",
                        "\"along\": \"=2*half\", \"across\": 1",
                        "none of the 8 inputs is one that 'reversal' speaks of"),
                argumentSet(
                        "property and input at once",
                        cases,
                        "\"property\": {",
                        "\"input\": {}, \"property\": {",
                        "must have exactly one of: input, generate, property"),
                argumentSet(
                        "property with points below 0",
                        cases,
                        "\"points\": 1,\n    \"property\"",
                        "\"points\": -1,\n    \"property\"",
                        "field 'points' must be a whole number from 0 to 100, got -1"),
                argumentSet(
                        "unknown field", json, "\"topic\"", "\"topics\"", "field 'topics' is not"),
                argumentSet(
                        "another truth for pixels",
                        json,
                        "\"topic\"",
                        "\"truth\": \"dda\", \"topic\"",
                        "field 'truth' is not for this topic"),
                argumentSet(
                        "title without Russian",
                        json,
                        ",\n    \"ru\": \"Отрезок по Брезенхему\"",
                        "",
                        "field 'title', field 'ru' is missing"),
                argumentSet(
                        "case's title without Russian",
                        cases,
                        ", \"ru\": \"последний пиксель нарисован\"",
                        "",
                        "cases.json[0], field 'title', field 'ru' is missing"),
                argumentSet(
                        "points beyond 100",
                        json,
                        "\"accuracy\": 70",
                        "\"accuracy\": 700",
                        "'accuracy' must be a whole number from 0 to 100, got 700"),
                argumentSet(
                        "points not adding up",
                        json,
                        "\"speed\": 10",
                        "\"speed\": 9",
                        "must add up to 100, got 70 + 20 + 9"),
                argumentSet(
                        "cases not adding up",
                        cases,
                        "\"points\": 2",
                        "\"points\": 1",
                        "accuracy cases have 69 points together, field 'points' says 70"),
                argumentSet(
                        "case file outside",
                        json,
                        "cases.json",
                        "../cases.json",
                        "'../cases.json' is not a file name"),
                argumentSet(
                        "case file missing",
                        json,
                        "hidden-",
                        "lost-",
                        "lost-cases.json: no such file to read"),
                argumentSet(
                        "unknown kind",
                        cases,
                        "\"accuracy\"",
                        "\"speed\"",
                        "cases.json[0], field 'kind' must be one of accuracy, stability, got "),
                argumentSet(
                        "group that the exercise has not",
                        cases,
                        "\"group\": \"order\"",
                        "\"group\": \"turn\"",
                        "field 'group' must be one of last-pixel, first-pixel, order"),
                argumentSet(
                        "mistake that the topic cannot tell",
                        json,
                        "\"shifted\"",
                        "\"moved\"",
                        "field 'mistakes' must be one of again, always-from-the-left, "),
                argumentSet(
                        "two groups of one name",
                        json,
                        "\"name\": \"first-pixel\"",
                        "\"name\": \"last-pixel\"",
                        "two groups are called 'last-pixel'"),
                argumentSet(
                        "same name twice",
                        cases,
                        "last-pixel-is-dropped",
                        "steep-line-leaves-gaps",
                        "two cases are called 'steep-line-leaves-gaps'"),
                argumentSet(
                        "point with one number",
                        cases,
                        "[7, 3]",
                        "[7]",
                        "field 'to' must be a point [x, y], got [7]"),
                argumentSet(
                        "coordinate beyond int",
                        cases,
                        "[7, 3]",
                        "[7, 3000000000]",
                        "from -2147483648 to 2147483647, got 3000000000"),
                argumentSet(
                        "endless segment without a cut",
                        cases,
                        "\"first\": 4000, ",
                        "",
                        "field 'first' is needed"),
                argumentSet(
                        "hazard that the topic has not",
                        cases,
                        "\"beyond-2-30\"",
                        "\"beyond-2-31\"",
                        "field 'hazard' must be one of first-octant, "),
                argumentSet(
                        "hazard and a segment",
                        cases,
                        "\"hazard\"",
                        "\"given\": {\"from\": [0, 0], \"to\": [1, 2]}, \"hazard\"",
                        "must have either 'given' or 'hazard', and not both"),
                argumentSet(
                        "shape that is not there",
                        "hidden-cases.json",
                        "\"octant-1\", \"count\"",
                        "\"octant-9\", \"count\"",
                        "'shape' must be one of octant-1, "),
                argumentSet(
                        "shape beside a template",
                        "hidden-cases.json",
                        "\"octant-1\", \"count\"",
                        "\"octant-1\", \"given\": {}, \"count\"",
                        "'given' must not stand beside 'shape'"),
                argumentSet(
                        "shape of a shape that is not there",
                        json,
                        "\"any\": [\"octant-1\"",
                        "\"any\": [\"octant-9\"",
                        "names of other shapes, at most three deep, got \"octant-9\""),
                argumentSet(
                        "number that is not drawn",
                        "hidden-cases.json",
                        "\"across\": \"0..along\"",
                        "\"across\": \"0..length\"",
                        "'length' is not a name that stands before it"),
                argumentSet(
                        "sum that is none",
                        json,
                        "\"=x+along\"",
                        "\"=x+\"",
                        "'x+' is not a sum of whole numbers and names"),
                argumentSet(
                        "range from the larger to the smaller",
                        json,
                        "\"0..999\"",
                        "\"999..0\"",
                        "must be a range from a smaller number to a larger one"),
                argumentSet(
                        "name of a number with a digit",
                        json,
                        "\"x\": \"0..999\"",
                        "\"x1\": \"0..999\"",
                        "'x1' is not the name of a number"),
                argumentSet(
                        "turns without a template",
                        json,
                        "\"point\": { \"from\": [\"=x\", \"=y\"], \"to\": [\"=x\", \"=y\"] }",
                        "\"point\": []",
                        "must be an input, or an array with at least one, got []"),
                argumentSet(
                        "speed on nothing",
                        json,
                        "\"count\": 120,",
                        "",
                        "field 'count' is missing"),
                argumentSet(
                        "more items than can be taken",
                        json,
                        "\"points\"",
                        "\"caps\": { \"items\": 65536 }, \"points\"",
                        "field 'caps', field 'items' must be a whole number from 1 to 65535, got 65536"),
                argumentSet(
                        "no bytes",
                        json,
                        "\"points\"",
                        "\"caps\": { \"bytes\": 0 }, \"points\"",
                        "field 'caps', field 'bytes' must be a whole number from 1 to 4128768, got 0"),
                argumentSet(
                        "more time than all calls have",
                        json,
                        "\"points\"",
                        "\"caps\": { \"seconds\": 8.5 }, \"points\"",
                        "field 'caps', field 'seconds' must be a number from 0.05 to 8.0, got 8.5"),
                argumentSet(
                        "limit without a name",
                        json,
                        "\"points\"",
                        "\"caps\": { \"pixels\": 100 }, \"points\"",
                        "field 'caps', field 'pixels' is not"),
                argumentSet(
                        "fewer items than a right answer has",
                        json,
                        "\"points\"",
                        "\"caps\": { \"items\": 9 }, \"points\"",
                        "exercise.json, field 'caps.items': the right answer of case"),
                argumentSet(
                        "fewer bytes than a right answer has",
                        json,
                        "\"points\"",
                        "\"caps\": { \"bytes\": 40 }, \"points\"",
                        "exercise.json, field 'caps.bytes': the right answer of case"),
                argumentSet(
                        "generated case shown",
                        "hidden-cases.json",
                        "after-deadline",
                        "open",
                        "field 'visibility' must not be open"));
    }
}
