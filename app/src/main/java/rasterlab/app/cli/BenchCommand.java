package rasterlab.app.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Unmatched;
import rasterlab.app.outcome.Complaint;

/** Lists the benchmarks in the help; the {@code ./lab} script starts them as another program. */
@Command(
        name = "bench",
        description = {
            "Compares the speed of our methods with the usual alternatives (Java2D, OpenGL); prints the ratios.",
            "It is a program of its own, built and started by the ./lab script;",
            "`./lab bench --help` lists its options."
        },
        footer = "Example: ./lab bench raster --only segments")
final class BenchCommand implements Callable<Integer> {
    @Parameters(arity = "0..*", paramLabel = "ARGUMENT", description = "handed to the benchmarks")
    private List<String> arguments = List.of();

    @Unmatched private List<String> options = new ArrayList<>();

    @Override
    public Integer call() {
        throw Complaint.badInput("benchmarks are started by the ./lab script: ./lab bench raster");
    }
}
