package rasterlab.app.cli;

import java.nio.charset.StandardCharsets;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import rasterlab.app.language.Language;
import rasterlab.app.light.MachBandsChart;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.perspective.PerspectiveChart;
import rasterlab.app.perspective.Stretch;
import rasterlab.app.precision.DepthPrecisionChart;
import rasterlab.app.study.ChartLook;
import rasterlab.app.visibility.GrowthChart;
import rasterlab.engine.transform.PerspectiveAmount;
import rasterlab.engine.visibility.depth.DepthPrecision;
import rasterlab.engine.visibility.hidden.Growth;

/**
 * A chart that {@code ./lab chart} draws.
 *
 * @param table what is printed
 * @param csv what a file of values has
 */
record Chart(
        String name,
        Supplier<TextTable> table,
        Function<Language, byte[]> svg,
        Function<Language, byte[]> png,
        Supplier<String> csv) {
    /** The charts as help lists them and the shell completes them. */
    static final class Names implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return all().stream().map(Chart::name).iterator();
        }
    }

    static List<Chart> all() {
        var growth = new GrowthChart();
        return List.of(
                new Chart(
                        "perspective",
                        Chart::perspective,
                        PerspectiveChart::svg,
                        language -> PngFile.bytes(PerspectiveChart.image(language)),
                        PerspectiveChart::csv),
                new Chart(
                        "depth-precision",
                        Chart::depthPrecision,
                        language -> DepthPrecisionChart.svg(language, ChartLook.PAPER),
                        language ->
                                PngFile.bytes(DepthPrecisionChart.image(language, ChartLook.PAPER)),
                        DepthPrecisionChart::csv),
                new Chart(
                        "mach-bands",
                        Chart::machBands,
                        MachBandsChart::svg,
                        language -> PngFile.bytes(MachBandsChart.image(language)),
                        MachBandsChart::csv),
                new Chart(
                        "visibility-growth",
                        () -> growth(growth),
                        language -> growth.svg(language, ChartLook.PAPER),
                        language -> PngFile.bytes(growth.image(language, ChartLook.PAPER)),
                        growth::csv));
    }

    /** The chart as a file of that kind: .svg, .png or .csv. */
    byte[] content(String extension, Language language) {
        return switch (extension) {
            case ".svg" -> svg.apply(language);
            case ".png" -> png.apply(language);
            default -> csv.get().getBytes(StandardCharsets.UTF_8);
        };
    }

    private static TextTable perspective() {
        var table = new TextTable("z'/dz'", "gamma", "stretch");
        for (PerspectiveAmount.Sample sample : PerspectiveChart.table())
            table.add(
                    List.of(
                            String.format(Locale.ROOT, "%.1f", sample.distance()),
                            String.format(Locale.ROOT, "%.3f", sample.gamma()),
                            Stretch.of(sample.distance()).code()));
        return table;
    }

    private static TextTable depthPrecision() {
        var table = new TextTable("format", "far/near", "measured", "predicted");
        for (DepthPrecision.Sample sample : DepthPrecisionChart.table())
            table.add(
                    List.of(
                            sample.format(),
                            String.format(Locale.ROOT, "%.0e", sample.ratio()),
                            String.format(Locale.ROOT, "%.3e", sample.measured()),
                            String.format(Locale.ROOT, "%.3e", sample.predicted())));
        return table;
    }

    private static TextTable machBands() {
        var table = new TextTable("shading", "largest step", "largest bend per face");
        MachBandsChart.profiles()
                .forEach(
                        (shading, profile) ->
                                table.add(
                                        List.of(
                                                shading,
                                                thousandths(profile.largestStep()),
                                                thousandths(profile.largestKink()))));
        return table;
    }

    private static String thousandths(double share) {
        return String.format(Locale.ROOT, "%.3f", share);
    }

    private static TextTable growth(GrowthChart growth) {
        var table = new TextTable("method", "N, one area", "N, one size", "n");
        for (String method : growth.methods())
            table.add(
                    Stream.concat(
                                    Stream.of(method),
                                    Stream.of(Growth.Axis.values())
                                            .map(axis -> growth.growth(method, axis).exponent())
                                            .map(p -> String.format(Locale.ROOT, "%.2f", p)))
                            .toList());
        return table;
    }
}
