package rasterlab.app.cli.study;

import java.nio.charset.StandardCharsets;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.language.Language;
import rasterlab.app.light.MachBandsChart;
import rasterlab.app.line.figure.BrightnessChart;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.perspective.PerspectiveChart;
import rasterlab.app.precision.DepthPrecisionChart;
import rasterlab.app.signmap.SignMapJson;
import rasterlab.app.signmap.SignMaps;
import rasterlab.app.signmap.SignSheet;
import rasterlab.app.visibility.GrowthChart;
import rasterlab.engine.signmap.SignMap;

/**
 * A chart that {@code ./lab chart} draws.
 *
 * @param table what is printed
 * @param csv what a file of values has
 * @param json the same with more, where there is more to say
 */
record Chart(
        String name,
        Function<ChartTables, TextTable> table,
        Function<Language, byte[]> svg,
        Function<Language, byte[]> png,
        Supplier<String> csv,
        Optional<Supplier<String>> json) {
    /** The chart of predicates that are named. */
    static final String OF_SIGNS = "sign-map";

    /** A chart that programs read as comma-separated values alone. */
    Chart(
            String name,
            Function<ChartTables, TextTable> table,
            Function<Language, byte[]> svg,
            Function<Language, byte[]> png,
            Supplier<String> csv) {
        this(name, table, svg, png, csv, Optional.empty());
    }

    /** The charts as help lists them and the shell completes them. */
    static final class Names implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return all(List.of(), List.of()).stream().map(Chart::name).iterator();
        }
    }

    /** The chart of methods that are named. */
    static final String OF_METHODS = "line-brightness";

    /**
     * @param methods that {@link #OF_METHODS} draws; none: the usual ones
     * @param predicates that {@link #OF_SIGNS} draws; none: the first one
     */
    static List<Chart> all(List<String> methods, List<String> predicates) {
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
                        growth::csv),
                segments(),
                signs(predicates));
    }

    private static Chart segments() {
        var chart = new CurveSegments();
        return new Chart(
                "curve-segments",
                tables -> tables.segments(chart.rows()),
                chart::svg,
                chart::png,
                chart::csv);
    }

    private static Chart signs(List<String> predicates) {
        var maps = new DrawnSigns(predicates);
        return new Chart(
                OF_SIGNS,
                tables -> tables.signs(maps.get()),
                language -> new SignSheet(maps.get(), language, ChartLook.PAPER).svg(),
                language ->
                        PngFile.bytes(new SignSheet(maps.get(), language, ChartLook.PAPER).image()),
                () -> SignMaps.csv(maps.get()),
                Optional.of(() -> SignMapJson.of(maps.get())));
    }

    /** Maps that are drawn once, when the first form is asked for. */
    private static final class DrawnSigns {
        private final List<String> predicates;
        private List<SignMap> maps = List.of();

        DrawnSigns(List<String> predicates) {
            this.predicates = predicates;
        }

        List<SignMap> get() {
            if (maps.isEmpty()) maps = SignMaps.of(predicates);
            return maps;
        }
    }

    /** The extensions of the files that it is written to. */
    List<String> extensions() {
        return json.isPresent()
                ? List.of(".svg", ".png", ".csv", ".json")
                : List.of(".svg", ".png", ".csv");
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

    /** The chart as a file of that kind, one of {@link #extensions}. */
    byte[] content(String extension, Language language) {
        return switch (extension) {
            case ".svg" -> svg.apply(language);
            case ".png" -> png.apply(language);
            case ".json" -> json.orElseThrow().get().getBytes(StandardCharsets.UTF_8);
            default -> csv.get().getBytes(StandardCharsets.UTF_8);
        };
    }
}
