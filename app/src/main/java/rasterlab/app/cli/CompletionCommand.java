package rasterlab.app.cli;

import java.util.concurrent.Callable;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import rasterlab.app.cli.console.Console;
import rasterlab.app.outcome.ExitCode;

/** Prints a script that completes commands and options. */
@Command(
        name = "completion",
        mixinStandardHelpOptions = true,
        description = "Prints the script that completes ./lab commands in bash and zsh.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:the script was printed", "2:an argument is wrong"},
        footer = "Example: source <(./lab completion)")
final class CompletionCommand implements Callable<Integer> {
    private final Console console;

    CompletionCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        console.out().print(AutoComplete.bash("lab", Lab.commandLine(console)));
        return ExitCode.DONE;
    }
}
