package rasterlab.app.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Unmatched;
import rasterlab.app.cli.console.Console;
import rasterlab.app.outcome.Complaint;

/** Lists the grading server in the help; the {@code ./lab} script starts it as another program. */
@Command(
        name = "grader",
        description = {
            "Starts the grading server; `./lab grader --help` lists what it does.",
            "It is a program of its own, started by the ./lab script."
        },
        footer = "Example: ./lab grader serve --data course --port 8080")
final class GraderCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(arity = "0..*", paramLabel = "ARGUMENT", description = "arguments for the server")
    private List<String> arguments = List.of();

    @Unmatched private List<String> options = new ArrayList<>();

    GraderCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        throw Complaint.badInput("the server is started by the ./lab script: ./lab grader serve");
    }
}
