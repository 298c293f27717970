package rasterlab.app.cli.study;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.NameList;
import rasterlab.app.line.BrightnessChart;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.naming.Named;

/** Draws a chart of a formula, and of what was measured where there is such. */
@Command(
        name = "chart",
        mixinStandardHelpOptions = true,
        description = {
            "Draws a chart and prints its table.",
            "perspective: the amount of perspective, gamma = 1 + 2*dz'/z', over z'/dz': how many",
            "  times larger the nearer of two equal depths appears, and where that runs away.",
            "depth-precision: the smallest distance that depth buffers tell apart half way to the",
            "  far plane, as a share of the depth, over far/near: measured, and by formula.",
            "mach-bands: brightness across a faceted sphere by flat, Gouraud's and Phong's shading.",
            "line-brightness: light that lines get for each pixel of their length, over their angle, by",
            "  the methods of topic line that --methods names.",
            "visibility-growth: the counted work of each visibility method over the number of faces N",
            "  and of pixels n, and its exponents: about N^2 against n*N, measured."
        },
        footer = {"", "Example: ./lab chart perspective --out gamma.svg"})
public final class ChartCommand implements Callable<Integer> {
    private static final List<String> EXTENSIONS = List.of(".svg", ".png", ".csv");

    private final Console console;

    @Parameters(
            index = "0",
            paramLabel = "CHART",
            description = "${COMPLETION-CANDIDATES}",
            completionCandidates = Chart.Names.class)
    private String name;

    @Option(
            names = "--out",
            paramLabel = "FILE",
            description = "file to write: .svg, .png or .csv; may be given several times")
    private List<Path> files = List.of();

    @Option(
            names = "--methods",
            paramLabel = "METHOD,…",
            description =
                    "methods for line-brightness (topic line); default: bresenham,naive-textbook")
    private List<String> methods = List.of();

    public ChartCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        Chart chart = chart();
        for (Path file : files) {
            extension(file);
            WholeFile.requireWritable(file);
        }
        var tables = new ChartTables(console.language().texts());
        chart.table().apply(tables).lines().forEach(console.out()::println);
        for (Path file : files) {
            WholeFile.write(file, chart.content(extension(file), console.language().inWindow()));
            console.tell("wrote", file.toString());
        }
        return ExitCode.DONE;
    }

    private Chart chart() {
        try {
            List<String> named = NameList.of("--methods", methods, BrightnessChart.known());
            BrightnessChart.requireKnown(named);
            Chart chart = Named.find("chart", name, Chart.all(named), Chart::name);
            if (!named.isEmpty() && !name.equals(Chart.OF_METHODS))
                throw new IllegalArgumentException("--methods is for chart " + Chart.OF_METHODS);
            return chart;
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
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
}
