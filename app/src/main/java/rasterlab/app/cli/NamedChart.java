package rasterlab.app.cli;

import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Supplier;
import rasterlab.app.language.Language;
import rasterlab.app.light.MachBandsChart;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.perspective.PerspectiveChart;
import rasterlab.app.perspective.Stretch;
import rasterlab.engine.transform.PerspectiveAmount.Sample;

/**
 * A chart that {@code ./lab chart} draws.
 *
 * @param table what is printed
 * @param csv its points
 */
record NamedChart(
        String name,
        Supplier<TextTable> table,
        Function<Language, byte[]> svg,
        Function<Language, BufferedImage> image,
        Supplier<String> csv) {

    static List<NamedChart> all() {
        return List.of(
                new NamedChart(
                        "perspective",
                        NamedChart::perspective,
                        PerspectiveChart::svg,
                        PerspectiveChart::image,
                        PerspectiveChart::csv),
                new NamedChart(
                        "mach-bands",
                        NamedChart::machBands,
                        MachBandsChart::svg,
                        MachBandsChart::image,
                        MachBandsChart::csv));
    }

    /**
     * @param extension .svg, .png or .csv
     */
    byte[] content(String extension, Language language) {
        return switch (extension) {
            case ".svg" -> svg.apply(language);
            case ".png" -> PngFile.bytes(image.apply(language));
            default -> csv.get().getBytes(StandardCharsets.UTF_8);
        };
    }

    private static TextTable perspective() {
        var table = new TextTable("z'/dz'", "gamma", "stretch");
        for (Sample sample : PerspectiveChart.table())
            table.add(
                    List.of(
                            String.format(Locale.ROOT, "%.1f", sample.distance()),
                            String.format(Locale.ROOT, "%.3f", sample.gamma()),
                            Stretch.of(sample.distance()).code()));
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
                                                String.format(
                                                        Locale.ROOT, "%.3f", profile.largestStep()),
                                                String.format(
                                                        Locale.ROOT,
                                                        "%.3f",
                                                        profile.largestKink()))));
        return table;
    }
}
