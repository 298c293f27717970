package rasterlab.app.cli.console;

import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;

/**
 * Turns every failure into one line on the error stream and an exit code, in the language that
 * {@code --lang} asks for.
 */
public final class Failures {
    private final PrintStream err;
    private final ReportLanguage language;
    private final ComplaintText complaints;

    public Failures(PrintStream err, ReportLanguage language) {
        this.err = err;
        this.language = language;
        complaints = new ComplaintText(language);
    }

    public int wrongArguments(ParameterException e, String[] args) {
        CommandLine command = e.getCommandLine();
        String name = command.getCommandSpec().qualifiedName(" ");
        say(name, complaints.of(e) + " " + language.texts().text("see", name));
        return ExitCode.BAD_INPUT;
    }

    public int failed(Exception e, CommandLine command, ParseResult parsed) {
        String name = command.getCommandSpec().qualifiedName(" ");
        if (e instanceof Complaint complaint) {
            say(name, complaints.of(complaint));
            return complaint.exitCode();
        }
        return fault(name, e);
    }

    /** Something that no command expected: one line here, all of it in a log file. */
    public int fault(String command, Throwable e) {
        say(command, language.texts().text("fault", e.toString(), logged(e)));
        return ExitCode.INTERNAL;
    }

    public int outOfMemory() {
        long mebibytes = Runtime.getRuntime().maxMemory() >> 20;
        say("./lab", language.texts().text("memory", mebibytes));
        return ExitCode.GAVE_UP;
    }

    private void say(String command, String message) {
        err.println(command + ": " + oneLine(message));
    }

    /** Line breaks and control characters of quoted input become spaces. */
    public static String oneLine(String message) {
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
