package rasterlab.app.cli;

import java.io.InputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.Failures;
import rasterlab.app.cli.console.HelpCommand;
import rasterlab.app.cli.console.OptionNumbers;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.cli.exercise.CheckCommand;
import rasterlab.app.cli.exercise.ExercisesCommand;
import rasterlab.app.cli.exercise.SubmitCommand;
import rasterlab.app.cli.render.OpenGlCommand;
import rasterlab.app.cli.render.PlanCommand;
import rasterlab.app.cli.render.RenderCommand;
import rasterlab.app.cli.run.RunCommand;
import rasterlab.app.cli.study.ChartCommand;
import rasterlab.app.cli.study.HazardsCommand;
import rasterlab.app.cli.study.MethodsCommand;
import rasterlab.app.cli.study.StudyCommand;
import rasterlab.app.language.Language;

/** The command line of Rasterlab. */
public final class Lab {
    private static final String OPEN = "open";

    /** The names of all commands, in the order of the help. */
    private static final List<String> COMMANDS =
            List.of(
                    "methods",
                    "run",
                    "study",
                    "chart",
                    "hazards",
                    "render",
                    "plan",
                    "opengl",
                    "exercises",
                    "check",
                    "submit",
                    OPEN,
                    "tour",
                    "grader",
                    "bench",
                    "completion",
                    HelpCommand.NAME);

    private Lab() {}

    /**
     * Runs one command.
     *
     * @param args command and options, as after {@code ./lab}
     * @param in what a command reads, such as the JSON of {@code run}
     * @param out receives results only, in UTF-8
     * @param err receives progress and complaints
     * @return the exit code
     */
    public static int run(String[] args, InputStream in, PrintStream out, PrintStream err) {
        ReportLanguage language = ReportLanguage.asked(args);
        var console = Console.of(in, out, err, language);
        try {
            return commandLine(console, wanted(args)).execute(args);
        } catch (OutOfMemoryError e) {
            return new Failures(console.err(), language).outOfMemory();
        } catch (Error e) {
            return new Failures(console.err(), language).fault("./lab", e);
        } finally {
            console.out().flush();
            console.err().flush();
        }
    }

    /** The language of the window that these arguments ask for; empty where they ask for more. */
    public static Optional<Language> windowIn(String[] args) {
        String words = String.join("=", args).toLowerCase(Locale.ROOT);
        return Stream.of(ReportLanguage.values())
                .filter(each -> words.equals("--lang=" + each.code()))
                .map(ReportLanguage::inWindow)
                .findFirst();
    }

    /** Whether a command of these arguments may have opened a window, which goes on without it. */
    public static boolean mayHaveOpened(String[] args) {
        return wanted(args).equals(List.of(OPEN));
    }

    /** Where the window tells what is wrong while there is none yet. */
    public static PrintStream notices() {
        return Console.of(System.in, System.out, System.err, ReportLanguage.EN).err();
    }

    /** The arguments to run where the given ones ask for the window, but there is no display. */
    public static String[] instead(String[] args) {
        Console.of(System.in, System.out, System.err, ReportLanguage.asked(args))
                .tell("no-display");
        return Stream.concat(Stream.of("tour"), Stream.of(args)).toArray(String[]::new);
    }

    /** All commands. */
    static CommandLine commandLine(Console console) {
        return commandLine(console, COMMANDS);
    }

    private static CommandLine commandLine(Console console, List<String> commands) {
        var lab = new CommandLine(new LabCommand(console));
        for (String command : commands) lab.addSubcommand(command(command, console));
        return configured(lab, console);
    }

    /** The command that these arguments begin with, alone; every one where they begin with none. */
    private static List<String> wanted(String... args) {
        boolean value = false;
        for (String word : args) {
            if (COMMANDS.contains(word) && !value && !word.equals(HelpCommand.NAME))
                return List.of(word);
            if (!word.startsWith("-") && !value) return COMMANDS;
            value = word.equals(LabCommand.LANGUAGE);
        }
        return COMMANDS;
    }

    /** Makes a command only when it is called, since each loads what it may need. */
    private static Object command(String name, Console console) {
        return switch (name) {
            case "methods" -> new MethodsCommand(console);
            case "run" -> new RunCommand(console);
            case "study" -> new StudyCommand(console);
            case "chart" -> new ChartCommand(console);
            case "hazards" -> new HazardsCommand(console);
            case "render" -> new RenderCommand(console);
            case "plan" -> new PlanCommand(console);
            case "opengl" -> OpenGlCommand.commandLine(console);
            case "exercises" -> ExercisesCommand.commandLine(console);
            case "check" -> new CheckCommand(console);
            case "submit" -> new SubmitCommand(console);
            case OPEN -> new OpenCommand(console);
            case "tour" -> new TourCommand(console);
            case "grader" -> new GraderCommand(console);
            case "bench" -> new BenchCommand();
            case "completion" -> new CompletionCommand(console);
            case HelpCommand.NAME -> new HelpCommand(console);
            default -> throw new AssertionError(name + " is no command");
        };
    }

    /** An empty name would stand for the folder that the command is called in. */
    private static Path file(String name) {
        if (name.isEmpty()) throw new TypeConversionException("must not be empty");
        return Path.of(name);
    }

    static CommandLine configured(CommandLine lab, Console console) {
        var failures = new Failures(console.err(), console.language());
        ITypeConverter<Double> number = OptionNumbers::number;
        ITypeConverter<Integer> whole = OptionNumbers::whole;
        return lab.setResourceBundle(console.language().help())
                .setOut(new PrintWriter(console.out(), true))
                .setErr(new PrintWriter(console.err(), true))
                .setColorScheme(CommandLine.Help.defaultColorScheme(Ansi.OFF))
                .setUsageHelpWidth(100)
                .registerConverter(ReportLanguage.class, ReportLanguage::named)
                .registerConverter(Double.class, number)
                .registerConverter(double.class, number)
                .registerConverter(Integer.class, whole)
                .registerConverter(int.class, whole)
                .registerConverter(Path.class, Lab::file)
                .setAbbreviatedOptionsAllowed(false)
                .setExpandAtFiles(false)
                .setParameterExceptionHandler(failures::wrongArguments)
                .setExecutionExceptionHandler(failures::failed);
    }
}
