package rasterlab.app.cli;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
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
import rasterlab.engine.transform.PerspectiveAmount.Sample;

/** Draws a chart of a formula, where there is nothing to measure. */
@Command(
        name = "chart",
        mixinStandardHelpOptions = true,
        description = {
            "Draws the chart of a formula and prints its table.",
            "perspective: the amount of perspective, gamma = 1 + 2*dz'/z', over z'/dz': how many",
            "  times larger the nearer of two equal depths appears, and where that runs away."
        },
        footer = {"", "Example: ./lab chart perspective --out gamma.svg"})
final class ChartCommand implements Callable<Integer> {
    private static final String ONLY = "perspective";
    private static final List<String> EXTENSIONS = List.of(".svg", ".png", ".csv");

    private final Console console;

    @Parameters(index = "0", paramLabel = "CHART", description = "perspective")
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

    @Override
    public Integer call() {
        if (!chart.equals(ONLY))
            throw Complaint.badInput("no chart '" + chart + "'; there is " + ONLY);
        for (Path file : files) {
            extension(file);
            WholeFile.requireWritable(file);
        }
        table().lines().forEach(console.out()::println);
        for (Path file : files) {
            WholeFile.write(file, content(extension(file), language.inWindow()));
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

    private static byte[] content(String extension, Language language) {
        return switch (extension) {
            case ".svg" -> PerspectiveChart.svg(language);
            case ".png" -> PngFile.bytes(PerspectiveChart.image(language));
            default -> PerspectiveChart.csv().getBytes(StandardCharsets.UTF_8);
        };
    }

    private static TextTable table() {
        var table = new TextTable("z'/dz'", "gamma", "stretch");
        for (Sample sample : PerspectiveChart.table())
            table.add(
                    List.of(
                            String.format(Locale.ROOT, "%.1f", sample.distance()),
                            String.format(Locale.ROOT, "%.3f", sample.gamma()),
                            Stretch.of(sample.distance()).code()));
        return table;
    }
}
