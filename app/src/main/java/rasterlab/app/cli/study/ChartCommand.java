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
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.line.figure.BrightnessChart;
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
            "  times larger the nearer of two equal depths appears, and where that grows without bound.",
            "depth-precision: the smallest distance that depth buffers tell apart half way to the",
            "  far plane, as a share of the depth, over far/near: measured, and by formula.",
            "mach-bands: brightness across a faceted sphere by flat, Gouraud's and Phong's shading.",
            "line-brightness: light that lines get for each pixel of their length, over their angle, by",
            "  the methods of topic line that --methods names.",
            "visibility-growth: the counted work of each visibility method over the number of faces N",
            "  and of pixels n, and its exponents: about N^2 against n*N, measured.",
            "sign-map: what a predicate answers around a point where its value is nearly 0, one pixel",
            "  for each neighbour that the numbers have; the wrong area is striped and measured."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the chart was drawn",
            "2:an argument is wrong, or a file cannot be written"
        },
        footer = {
            "",
            "Example: ./lab chart perspective --out gamma.svg",
            "Example: ./lab chart sign-map point-in-triangle/half-plane --out signs.png"
        })
public final class ChartCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(
            index = "0",
            paramLabel = "CHART",
            description = "${COMPLETION-CANDIDATES}",
            completionCandidates = Chart.Names.class)
    private String name;

    @Parameters(
            index = "1..*",
            arity = "0..*",
            paramLabel = "TOPIC/METHOD",
            description = {
                "for sign-map: a topic or predicate, all its methods or one;",
                "default: orientation, in all its forms"
            })
    private List<String> predicates = List.of();

    @Option(
            names = "--out",
            paramLabel = "FILE",
            description =
                    "file to write: .svg, .png or .csv, a sign map .json too; may be given several times")
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
            extension(chart, file);
            WholeFile.requireWritable(file);
        }
        table(chart).lines().forEach(console.out()::println);
        for (Path file : files) {
            WholeFile.write(
                    file, chart.content(extension(chart, file), console.language().inWindow()));
            console.tell("wrote", file.toString());
        }
        return ExitCode.DONE;
    }

    private TextTable table(Chart chart) {
        try {
            return chart.table().apply(new ChartTables(console.language().texts()));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    private Chart chart() {
        try {
            List<String> named = NameList.of("--methods", methods, BrightnessChart.known());
            BrightnessChart.requireKnown(named);
            Chart chart = Named.find("chart", name, Chart.all(named, predicates), Chart::name);
            if (!predicates.isEmpty() && !name.equals(Chart.OF_SIGNS))
                throw new IllegalArgumentException("TOPIC/METHOD is for chart " + Chart.OF_SIGNS);
            if (!named.isEmpty() && !name.equals(Chart.OF_METHODS))
                throw new IllegalArgumentException("--methods is for chart " + Chart.OF_METHODS);
            return chart;
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    private static String extension(Chart chart, Path file) {
        String named = file.toString().toLowerCase(Locale.ROOT);
        return chart.extensions().stream()
                .filter(named::endsWith)
                .findFirst()
                .orElseThrow(
                        () ->
                                Complaint.badInput(
                                        file
                                                + ": unknown extension; allowed are "
                                                + String.join(", ", chart.extensions())));
    }
}
