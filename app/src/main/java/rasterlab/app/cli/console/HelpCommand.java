package rasterlab.app.cli.console;

import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import rasterlab.app.outcome.ExitCode;
import rasterlab.engine.naming.Named;

/**
 * Shows the help of a command below its own, named step by step: {@code help exercises new} shows
 * what {@code exercises help new} does.
 */
@Command(
        name = HelpCommand.NAME,
        helpCommand = true,
        description = {
            "Shows the help of a command, as in `./lab help exercises new`.",
            "Without COMMAND it lists the commands."
        })
public final class HelpCommand implements Callable<Integer> {
    public static final String NAME = "help";

    private final Console console;

    @Spec private CommandSpec spec;

    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "Shows this help and exits.")
    private boolean help;

    @Parameters(
            arity = "0..*",
            paramLabel = "COMMAND",
            description = "the command, and the one below it if there is one")
    private List<String> names = List.of();

    public HelpCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        CommandLine shown = spec.parent().commandLine();
        for (String name : names) {
            CommandLine below = shown.getSubcommands().get(name);
            if (below == null) throw new ParameterException(shown, noCommand(shown, name));
            shown = below;
        }
        shown.usage(console.out());
        return ExitCode.DONE;
    }

    private static String noCommand(CommandLine above, String name) {
        Set<String> known = above.getSubcommands().keySet();
        return known.isEmpty()
                ? "%s has no commands below it, got '%s'".formatted(above.getCommandName(), name)
                : Named.unknown("command", name, known);
    }
}
