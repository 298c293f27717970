package rasterlab.app.row;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import rasterlab.engine.study.Verdict;

/**
 * A row as it is right, as a method has it, and how far the two are apart.
 *
 * @param bands what is right, then what the method made of it, if it did not refuse
 * @param wrong of each pixel, whether it is beyond what the topic calls usable
 * @param errors of each pixel, in the topic's unit; none where the method refused or crashed
 * @param numbers of a pixel
 * @param image what a filter makes smaller or larger; empty for other topics
 */
record RowScene(
        List<ColorBand> bands,
        boolean[] wrong,
        double[] errors,
        Verdict verdict,
        IntFunction<PixelNumbers> numbers,
        Optional<FilteredImage> image) {
    /**
     * @param key of its name
     * @param argb of each pixel, 0xAARRGGBB
     * @param words of each pixel, written where there is room
     */
    record ColorBand(String key, int[] argb, IntFunction<String> words) {
        /** Colours that speak for themselves. */
        ColorBand(String key, int[] argb) {
            this(key, argb, pixel -> "");
        }
    }

    /**
     * @param headings keys of the columns
     */
    record PixelNumbers(List<String> headings, List<NumberRow> lines) {
        /**
         * Coordinates as they are right, beside those of a method.
         *
         * @param made by the method; empty where it gave no answer
         */
        static PixelNumbers of(List<String> names, double[] right, Optional<double[]> made) {
            var headings = new ArrayList<>(List.of("coordinate", "right"));
            if (made.isPresent()) headings.add("method");
            var lines = new ArrayList<NumberRow>();
            for (int i = 0; i < right.length; i++)
                lines.add(
                        made.isEmpty()
                                ? new NumberRow(names.get(i), right[i])
                                : new NumberRow(names.get(i), right[i], made.get()[i]));
            return new PixelNumbers(headings, lines);
        }
    }

    record NumberRow(String name, double... values) {}

    /**
     * @param argb row by row, the bottom row first
     * @param footprints s, t, ds/dx, dt/dx, ds/dy, dt/dy of each pixel
     */
    record FilteredImage(int width, int height, int[] argb, double[] footprints) {}

    int pixels() {
        return bands.get(0).argb().length;
    }

    int wrongPixels() {
        int count = 0;
        for (boolean each : wrong) if (each) count++;
        return count;
    }
}
