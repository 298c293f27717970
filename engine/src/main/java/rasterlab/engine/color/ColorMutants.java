package rasterlab.engine.color;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.engine.study.Mutant;

/** Colours written in another model with one mistake. */
final class ColorMutants {
    private static final ColorConverter RIGHT = new FormulaColors();

    private ColorMutants() {}

    static List<Mutant<ColorConverter>> all() {
        double[] black = {0, 0, 0};
        return List.of(
                new Mutant<>("negative-hues", "pure-colours", ColorMutants::negativeHues),
                new Mutant<>("red-blue-swapped", "pure-colours", ColorMutants::blueFirst),
                new Mutant<>("full-turn-is-black", "full-turn", ColorMutants::sixSectors),
                new Mutant<>(
                        "same-model-copied",
                        "to-itself",
                        (from, components, to) ->
                                from == to
                                        ? components.clone()
                                        : RIGHT.convert(from, components, to)),
                new Mutant<>("grey-has-hue-0", "grey", ColorMutants::grayIsRed),
                new Mutant<>("nearly-grey-is-grey", "nearly-grey", ColorMutants::nearlyGray),
                new Mutant<>("black-divides-by-0", "black", ColorMutants::blackByDivision),
                new Mutant<>("cut-to-bytes", "between-levels", ColorMutants::bytes),
                new Mutant<>(
                        "array-shared",
                        "black",
                        (from, components, to) -> {
                            double[] right = RIGHT.convert(from, components, to);
                            return to == ColorModel.RGB && Arrays.equals(right, black)
                                    ? black
                                    : right;
                        }),
                new Mutant<>(
                        "argument-returned",
                        "to-itself",
                        (from, components, to) -> {
                            double[] right = RIGHT.convert(from, components, to);
                            return Arrays.equals(right, components) ? components : right;
                        }),
                new Mutant<>(
                        "saturation-not-divided", "between-levels", ColorMutants::wholeSaturation),
                new Mutant<>("inks-not-divided", "between-levels", ColorMutants::wholeInks),
                new Mutant<>("value-is-the-mean", "pure-colours", ColorMutants::meanValue),
                new Mutant<>("hue-in-sixths", "pure-colours", ColorMutants::sixths),
                new Mutant<>("hue-in-radians", "pure-colours", ColorMutants::radians));
    }

    private static double[] negativeHues(ColorModel from, double[] components, ColorModel to) {
        double[] answer = RIGHT.convert(from, components, to);
        if (to == ColorModel.HSV && answer[0] >= 300) answer[0] -= 360;
        return answer;
    }

    private static double[] blueFirst(ColorModel from, double[] components, ColorModel to) {
        double[] rgb = RIGHT.convert(from, components, ColorModel.RGB);
        return RIGHT.convert(ColorModel.RGB, new double[] {rgb[2], rgb[1], rgb[0]}, to);
    }

    private static double[] sixSectors(ColorModel from, double[] components, ColorModel to) {
        boolean seventh = from == ColorModel.HSV && components[0] == 360;
        return seventh
                ? RIGHT.convert(ColorModel.RGB, new double[3], to)
                : RIGHT.convert(from, components, to);
    }

    private static double[] grayIsRed(ColorModel from, double[] components, ColorModel to) {
        double[] answer = RIGHT.convert(from, components, to);
        if (Double.isNaN(answer[0])) answer[0] = 0;
        return answer;
    }

    private static double[] nearlyGray(ColorModel from, double[] components, ColorModel to) {
        double[] rgb = RIGHT.convert(from, components, ColorModel.RGB);
        double[] sorted = rgb.clone();
        Arrays.sort(sorted);
        if (sorted[2] - sorted[0] < 0.01) Arrays.fill(rgb, sorted[1]);
        return RIGHT.convert(ColorModel.RGB, rgb, to);
    }

    private static double[] blackByDivision(ColorModel from, double[] components, ColorModel to) {
        double[] answer = RIGHT.convert(from, components, to);
        if (to == ColorModel.CMYK && answer[3] == 1) Arrays.fill(answer, 0, 3, 0.0 / 0.0);
        return answer;
    }

    private static double[] bytes(ColorModel from, double[] components, ColorModel to) {
        double[] rgb = RIGHT.convert(from, components, ColorModel.RGB);
        for (int i = 0; i < 3; i++) rgb[i] = (int) (255 * rgb[i]) / 255.0;
        return RIGHT.convert(ColorModel.RGB, rgb, to);
    }

    private static double[] wholeSaturation(ColorModel from, double[] components, ColorModel to) {
        double[] answer = RIGHT.convert(from, components, to);
        if (to == ColorModel.HSV) answer[1] *= answer[2];
        return answer;
    }

    /** The share that black leaves is not taken for the whole. */
    private static double[] wholeInks(ColorModel from, double[] components, ColorModel to) {
        double[] answer = RIGHT.convert(from, components, to);
        if (to == ColorModel.CMYK) for (int i = 0; i < 3; i++) answer[i] *= 1 - answer[3];
        return answer;
    }

    private static double[] meanValue(ColorModel from, double[] components, ColorModel to) {
        double[] answer = RIGHT.convert(from, components, to);
        if (to == ColorModel.HSV) {
            double[] rgb = RIGHT.convert(from, components, ColorModel.RGB);
            answer[2] = (rgb[0] + rgb[1] + rgb[2]) / 3;
        }
        return answer;
    }

    /** Answers the side of the hexagon, from 0 to 6, in place of degrees. */
    private static double[] sixths(ColorModel from, double[] components, ColorModel to) {
        double[] answer = RIGHT.convert(from, components, to);
        if (to == ColorModel.HSV) answer[0] /= 60;
        return answer;
    }

    /** Answers the hue of HVS, which comes from an arc tangent, in radians. */
    private static double[] radians(ColorModel from, double[] components, ColorModel to) {
        double[] answer = RIGHT.convert(from, components, to);
        if (to == ColorModel.HVS) answer[0] = Math.toRadians(answer[0]);
        return answer;
    }
}
