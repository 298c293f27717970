package rasterlab.app.cli;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.light.MachBandsChart;
import rasterlab.app.line.BrightnessChart;
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
        Function<Texts, TextTable> table,
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
                brightness(methods),
                new Chart(
                        "visibility-growth",
                        texts -> growth(growth, texts),
                        language -> growth.svg(language, ChartLook.PAPER),
                        language -> PngFile.bytes(growth.image(language, ChartLook.PAPER)),
                        growth::csv));
    }

    private static Chart brightness(List<String> methods) {
        Supplier<BrightnessChart> chart = () -> new BrightnessChart(methods);
        return new Chart(
                OF_METHODS,
                texts -> brightness(chart.get(), texts),
                language -> chart.get().svg(language),
                language -> PngFile.bytes(chart.get().image(language)),
                () -> chart.get().csv());
    }

    private static TextTable brightness(BrightnessChart chart, Texts texts) {
        List<Integer> angles = List.of(0, 30, 45, 90);
        var heads = new ArrayList<>(List.of(texts.text("chart.method")));
        for (int angle : angles) heads.add(texts.text("chart.degrees", angle));
        var table = new TextTable(heads);
        for (String method : chart.methods())
            table.add(
                    Stream.concat(
                                    Stream.of(method),
                                    angles.stream()
                                            .map(degrees -> chart.light(method).get(degrees))
                                            .map(each -> lightOrNone(each, texts)))
                            .toList());
        return table;
    }

    private static String lightOrNone(double light, Texts texts) {
        return Double.isNaN(light) ? "-" : thousandths(light, texts);
    }

    /** The chart as a file of that kind: .svg, .png or .csv. */
    byte[] content(String extension, Language language) {
        return switch (extension) {
            case ".svg" -> svg.apply(language);
            case ".png" -> png.apply(language);
            default -> csv.get().getBytes(StandardCharsets.UTF_8);
        };
    }

    private static TextTable perspective(Texts texts) {
        var table = new TextTable("z'/dz'", "gamma", texts.text("chart.stretch"));
        for (PerspectiveAmount.Sample sample : PerspectiveChart.table())
            table.add(
                    List.of(
                            String.format(texts.locale(), "%.1f", sample.distance()),
                            String.format(texts.locale(), "%.3f", sample.gamma()),
                            texts.text("stretch." + Stretch.of(sample.distance()).code())));
        return table;
    }

    private static TextTable depthPrecision(Texts texts) {
        var table =
                new TextTable(
                        texts.text("chart.format"),
                        "far/near",
                        texts.text("chart.measured"),
                        texts.text("chart.predicted"));
        for (DepthPrecision.Sample sample : DepthPrecisionChart.table())
            table.add(
                    List.of(
                            sample.format(),
                            String.format(texts.locale(), "%.0e", sample.ratio()),
                            String.format(texts.locale(), "%.3e", sample.measured()),
                            String.format(texts.locale(), "%.3e", sample.predicted())));
        return table;
    }

    private static TextTable machBands(Texts texts) {
        var table =
                new TextTable(
                        texts.text("chart.shading"),
                        texts.text("chart.step"),
                        texts.text("chart.bend"));
        MachBandsChart.profiles()
                .forEach(
                        (shading, profile) ->
                                table.add(
                                        List.of(
                                                shading,
                                                thousandths(profile.largestStep(), texts),
                                                thousandths(profile.largestKink(), texts))));
        return table;
    }

    private static String thousandths(double share, Texts texts) {
        return String.format(texts.locale(), "%.3f", share);
    }

    private static TextTable growth(GrowthChart growth, Texts texts) {
        var table =
                new TextTable(
                        texts.text("chart.method"),
                        texts.text("chart.area"),
                        texts.text("chart.size"),
                        "n");
        for (String method : growth.methods())
            table.add(
                    Stream.concat(
                                    Stream.of(method),
                                    Stream.of(Growth.Axis.values())
                                            .map(axis -> growth.growth(method, axis).exponent())
                                            .map(p -> String.format(texts.locale(), "%.2f", p)))
                            .toList());
        return table;
    }
}
