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
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;

/** Turns every failure into one line on the error stream and an exit code. */
final class Failures {
    private final PrintStream err;

    Failures(PrintStream err) {
        this.err = err;
    }

    int wrongArguments(ParameterException e, String[] args) {
        CommandLine command = e.getCommandLine();
        String name = command.getCommandSpec().qualifiedName(" ");
        say(name, explanation(e) + " (see `" + name + " --help`)");
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
            say(name, complaint.getMessage());
            return complaint.exitCode();
        }
        return fault(name, e);
    }

    /** Something that no command expected: one line here, all of it in a log file. */
    int fault(String command, Throwable e) {
        say(command, "this is a fault of Rasterlab (" + e + "); details: " + logged(e));
        return ExitCode.INTERNAL;
    }

    int outOfMemory() {
        long mebibytes = Runtime.getRuntime().maxMemory() >> 20;
        say("./lab", "this needs more than the " + mebibytes + " MiB that Java may use here");
        return ExitCode.GAVE_UP;
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
