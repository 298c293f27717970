package rasterlab.app.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;
import rasterlab.app.language.Complaints;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;

/**
 * Turns every failure into one line on the error stream and an exit code, in the language that
 * {@code --lang} asks for.
 */
final class Failures {
    /** Names that picocli quotes, of which a sentence may have any number. */
    private static final String QUOTED = "(?<![\\p{L}\\d])'([^']*)'(?![\\p{L}\\d])";

    private final PrintStream err;
    private final ReportLanguage language;

    Failures(PrintStream err, ReportLanguage language) {
        this.err = err;
        this.language = language;
    }

    int wrongArguments(ParameterException e, String[] args) {
        CommandLine command = e.getCommandLine();
        String name = command.getCommandSpec().qualifiedName(" ");
        say(name, said(explanation(e)) + " " + language.texts().text("see", name));
        return ExitCode.BAD_INPUT;
    }

    private static String explanation(ParameterException e) {
        if (!(e instanceof UnmatchedArgumentException unmatched)) return lowerFirst(e.getMessage());
        String wrong = unmatched.getUnmatched().get(0);
        CommandLine command = e.getCommandLine();
        boolean option = unmatched.isUnknownOption();
        boolean subcommand = !option && !command.getSubcommands().isEmpty();
        Collection<String> known =
                option
                        ? command.getCommandSpec().optionsMap().keySet()
                        : command.getSubcommands().keySet();
        return "unknown "
                + (option ? "option" : subcommand ? "command" : "argument")
                + " '"
                + wrong
                + "'"
                + Closest.to(wrong, known).map(near -> "; did you mean '" + near + "'?").orElse("");
    }

    private static String lowerFirst(String sentence) {
        return Character.toLowerCase(sentence.charAt(0)) + sentence.substring(1);
    }

    int failed(Exception e, CommandLine command, ParseResult parsed) {
        String name = command.getCommandSpec().qualifiedName(" ");
        if (e instanceof Complaint complaint) {
            say(name, said(complaint.getMessage()));
            return complaint.exitCode();
        }
        return fault(name, e);
    }

    /** Something that no command expected: one line here, all of it in a log file. */
    int fault(String command, Throwable e) {
        say(command, language.texts().text("fault", e.toString(), logged(e)));
        return ExitCode.INTERNAL;
    }

    int outOfMemory() {
        long mebibytes = Runtime.getRuntime().maxMemory() >> 20;
        say("./lab", language.texts().text("memory", mebibytes));
        return ExitCode.GAVE_UP;
    }

    /** English stays as it is, its numbers too: scripts may read them. */
    private String said(String english) {
        return language == ReportLanguage.EN
                ? english
                : Complaints.said(language.inWindow(), english).replaceAll(QUOTED, "«$1»");
    }

    private void say(String command, String message) {
        err.println(command + ": " + oneLine(message));
    }

    /** Line breaks and control characters of quoted input become spaces. */
    static String oneLine(String message) {
        return message.replaceAll("\\p{Cntrl}+", " ").strip();
    }

    private static String logged(Throwable e) {
        var text = new StringWriter();
        e.printStackTrace(new PrintWriter(text, true));
        try {
            Path log = Files.createTempFile("rasterlab-fault-", ".log");
            return Files.writeString(log, text.toString()).toString();
        } catch (IOException unwritable) {
            return "no log could be written: " + unwritable.getMessage();
        }
    }
}
