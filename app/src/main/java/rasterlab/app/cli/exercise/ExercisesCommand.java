package rasterlab.app.cli.exercise;

import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.HelpCommand;

/** The catalogue of exercises: seen, proved, checked and begun. */
@Command(
        name = "exercises",
        mixinStandardHelpOptions = true,
        synopsisSubcommandLabel = "COMMAND",
        description = {
            "Lists the exercises, proves them, and helps to write new ones, which are data alone.",
        },
        footer = {"", "Example: ./lab exercises prove point-in-polygon"})
public final class ExercisesCommand implements Callable<Integer> {
    @Spec private CommandSpec spec;

    private ExercisesCommand() {}

    public static CommandLine commandLine(Console console) {
        return new CommandLine(new ExercisesCommand())
                .addSubcommand(new ExercisesListCommand(console))
                .addSubcommand(new ExercisesProveCommand(console))
                .addSubcommand(new ExercisesValidateCommand(console))
                .addSubcommand(new ExercisesNewCommand(console))
                .addSubcommand(new HelpCommand(console));
    }

    @Override
    public Integer call() {
        throw new ParameterException(spec.commandLine(), "Missing required subcommand");
    }
}
