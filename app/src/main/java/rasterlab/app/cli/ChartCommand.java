package rasterlab.app.cli;

import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.perspective.PerspectiveChart;
import rasterlab.app.perspective.Stretch;
import rasterlab.app.visibility.GrowthChart;
import rasterlab.engine.transform.PerspectiveAmount.Sample;
import rasterlab.engine.visibility.hidden.Growth;

/** Draws a chart of a formula or of what is counted, where no time is measured. */
@Command(
        name = "chart",
        mixinStandardHelpOptions = true,
        description = {
            "Draws the chart of a formula or of counts and prints its table.",
            "perspective: the amount of perspective, gamma = 1 + 2*dz'/z', over z'/dz': how many",
            "  times larger the nearer of two equal depths appears, and where that runs away.",
            "visibility-growth: the counted work of each visibility method over the number of faces N",
            "  and of pixels n, and its exponents: about N^2 against n*N, measured."
        },
        footer = {"", "Example: ./lab chart perspective --out gamma.svg"})
final class ChartCommand implements Callable<Integer> {
    private static final Map<String, Supplier<Chart>> CHARTS =
            new TreeMap<>(
                    Map.of(
                            "perspective", ChartCommand::perspective,
                            "visibility-growth", ChartCommand::growth));
    private static final List<String> EXTENSIONS = List.of(".svg", ".png", ".csv");

    private final Console console;

    @Parameters(index = "0", paramLabel = "CHART", description = "perspective or visibility-growth")
    private String chart;

    @Option(
            names = "--out",
            paramLabel = "FILE",
            description = "file to write: .svg, .png or .csv; may be given several times")
    private List<Path> files = List.of();

    @Option(
            names = "--lang",
            paramLabel = "LANGUAGE",
            description = "of the chart: en or ru; default: en")
    private ReportLanguage language = ReportLanguage.EN;

    ChartCommand(Console console) {
        this.console = console;
    }

    /** One chart in all its forms. */
    private record Chart(
            Function<Language, byte[]> svg,
            Function<Language, BufferedImage> image,
            Supplier<String> csv,
            TextTable table) {
        byte[] content(String extension, Language language) {
            return switch (extension) {
                case ".svg" -> svg.apply(language);
                case ".png" -> PngFile.bytes(image.apply(language));
                default -> csv.get().getBytes(StandardCharsets.UTF_8);
            };
        }
    }

    @Override
    public Integer call() {
        if (!CHARTS.containsKey(chart))
            throw Complaint.badInput(
                    "no chart '%s'; there are %s"
                            .formatted(chart, String.join(", ", CHARTS.keySet())));
        for (Path file : files) {
            extension(file);
            WholeFile.requireWritable(file);
        }
        Chart chosen = CHARTS.get(chart).get();
        chosen.table.lines().forEach(console.out()::println);
        for (Path file : files) {
            WholeFile.write(file, chosen.content(extension(file), language.inWindow()));
            console.err().println("wrote " + file);
        }
        return ExitCode.DONE;
    }

    private static String extension(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return EXTENSIONS.stream()
                .filter(name::endsWith)
                .findFirst()
                .orElseThrow(
                        () ->
                                Complaint.badInput(
                                        file
                                                + ": unknown extension; allowed are "
                                                + String.join(", ", EXTENSIONS)));
    }

    private static Chart perspective() {
        var table = new TextTable("z'/dz'", "gamma", "stretch");
        for (Sample sample : PerspectiveChart.table())
            table.add(
                    List.of(
                            String.format(Locale.ROOT, "%.1f", sample.distance()),
                            String.format(Locale.ROOT, "%.3f", sample.gamma()),
                            Stretch.of(sample.distance()).code()));
        return new Chart(
                PerspectiveChart::svg, PerspectiveChart::image, PerspectiveChart::csv, table);
    }

    private static Chart growth() {
        var growth = new GrowthChart();
        var table = new TextTable("method", "N, one area", "N, one size", "n");
        for (String method : growth.methods())
            table.add(
                    Stream.concat(
                                    Stream.of(method),
                                    Stream.of(Growth.Axis.values())
                                            .map(axis -> growth.growth(method, axis).exponent())
                                            .map(p -> String.format(Locale.ROOT, "%.2f", p)))
                            .toList());
        return new Chart(growth::svg, growth::image, growth::csv, table);
    }
}
