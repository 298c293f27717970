package rasterlab.app.cli.console;

import java.util.Collection;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.naming.Named;

/**
 * Says in one language what is wrong with a command line or with the things that it names. Numbers
 * stay as they are typed: scripts and people may take them from here.
 */
public record ComplaintText(ReportLanguage language) {
    public String of(ParameterException e) {
        return of(explanation(e));
    }

    String of(Complaint complaint) {
        return of(complaint.getMessage());
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
        if (subcommand) return Named.unknown("command", wrong, known);
        return "unknown %s '%s'".formatted(option ? "option" : "argument", wrong)
                + Named.suggestion(wrong, known);
    }

    private static String lowerFirst(String sentence) {
        return Character.toLowerCase(sentence.charAt(0)) + sentence.substring(1);
    }

    /** A note beside an answer, with numbers as prose has them: nobody types them. */
    public String note(String english) {
        return language.inWindow() == Language.ENGLISH
                ? of(english)
                : Complaints.translated(language.inWindow(), english);
    }

    /** A sentence of the engine. */
    String of(String english) {
        return Complaints.saidToTypist(language.inWindow(), english);
    }
}
