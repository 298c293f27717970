package rasterlab.app.cli.study;

import java.nio.charset.StandardCharsets;
import java.util.Iterator;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.language.Language;
import rasterlab.app.light.MachBandsChart;
import rasterlab.app.line.BrightnessChart;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.perspective.PerspectiveChart;
import rasterlab.app.precision.DepthPrecisionChart;
import rasterlab.app.visibility.GrowthChart;

/**
 * A chart that {@code ./lab chart} draws.
 *
 * @param table what is printed
 * @param csv what a file of values has
 */
record Chart(
        String name,
        Function<ChartTables, TextTable> table,
        Function<Language, byte[]> svg,
        Function<Language, byte[]> png,
        Supplier<String> csv) {
    /** The charts as help lists them and the shell completes them. */
    static final class Names implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return all(List.of()).stream().map(Chart::name).iterator();
        }
    }

    /** The chart of methods that are named. */
    static final String OF_METHODS = "line-brightness";

    /**
     * @param methods that {@link #OF_METHODS} draws; none: the usual ones
     */
    static List<Chart> all(List<String> methods) {
        var growth = new GrowthChart();
        return List.of(
                new Chart(
                        "perspective",
                        ChartTables::perspective,
                        PerspectiveChart::svg,
                        language -> PngFile.bytes(PerspectiveChart.image(language)),
                        PerspectiveChart::csv),
                new Chart(
                        "depth-precision",
                        ChartTables::depthPrecision,
                        language -> DepthPrecisionChart.svg(language, ChartLook.PAPER),
                        language ->
                                PngFile.bytes(DepthPrecisionChart.image(language, ChartLook.PAPER)),
                        DepthPrecisionChart::csv),
                new Chart(
                        "mach-bands",
                        ChartTables::machBands,
                        MachBandsChart::svg,
                        language -> PngFile.bytes(MachBandsChart.image(language)),
                        MachBandsChart::csv),
                brightness(methods),
                new Chart(
                        "visibility-growth",
                        tables -> tables.growth(growth),
                        language -> growth.svg(language, ChartLook.PAPER),
                        language -> PngFile.bytes(growth.image(language, ChartLook.PAPER)),
                        growth::csv));
    }

    private static Chart brightness(List<String> methods) {
        Supplier<BrightnessChart> chart = () -> new BrightnessChart(methods);
        return new Chart(
                OF_METHODS,
                tables -> tables.brightness(chart.get()),
                language -> chart.get().svg(language),
                language -> PngFile.bytes(chart.get().image(language)),
                () -> chart.get().csv());
    }

    /** The chart as a file of that kind: .svg, .png or .csv. */
    byte[] content(String extension, Language language) {
        return switch (extension) {
            case ".svg" -> svg.apply(language);
            case ".png" -> png.apply(language);
            default -> csv.get().getBytes(StandardCharsets.UTF_8);
        };
    }
}
