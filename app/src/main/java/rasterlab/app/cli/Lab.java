package rasterlab.app.cli;

import java.io.InputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;

/** The command line of Rasterlab. */
public final class Lab {
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
        var console = Console.of(in, out, err);
        ReportLanguage language = ReportLanguage.asked(args);
        try {
            return commandLine(console, language).execute(args);
        } catch (OutOfMemoryError e) {
            return new Failures(console.err(), language).outOfMemory();
        } catch (Error e) {
            return new Failures(console.err(), language).fault("./lab", e);
        } finally {
            console.out().flush();
            console.err().flush();
        }
    }

    static CommandLine commandLine(Console console) {
        return commandLine(console, ReportLanguage.EN);
    }

    private static CommandLine commandLine(Console console, ReportLanguage language) {
        var lab = new CommandLine(new LabCommand(console));
        lab.addSubcommand(new MethodsCommand(console));
        lab.addSubcommand(new RunCommand(console));
        lab.addSubcommand(new StudyCommand(console));
        lab.addSubcommand(new ChartCommand(console));
        lab.addSubcommand(new HazardsCommand(console));
        lab.addSubcommand(new RenderCommand(console));
        lab.addSubcommand(OpenGlCommand.commandLine(console));
        lab.addSubcommand(new CheckCommand(console));
        lab.addSubcommand(new TourCommand(console));
        lab.addSubcommand(new GraderCommand(console));
        lab.addSubcommand(new BenchCommand());
        lab.addSubcommand(new CompletionCommand(console));
        lab.addSubcommand(new CommandLine.HelpCommand());
        return configured(lab, console, language);
    }

    private static CommandLine configured(
            CommandLine lab, Console console, ReportLanguage language) {
        var failures = new Failures(console.err(), language);
        return lab.setOut(new PrintWriter(console.out(), true))
                .setErr(new PrintWriter(console.err(), true))
                .setColorScheme(CommandLine.Help.defaultColorScheme(Ansi.OFF))
                .setUsageHelpWidth(100)
                .registerConverter(ReportLanguage.class, ReportLanguage::named)
                .registerConverter(Double.class, NumberText::number)
                .registerConverter(double.class, NumberText::number)
                .registerConverter(Integer.class, NumberText::whole)
                .registerConverter(int.class, NumberText::whole)
                .setAbbreviatedOptionsAllowed(false)
                .setParameterExceptionHandler(failures::wrongArguments)
                .setExecutionExceptionHandler(failures::failed);
    }
}
