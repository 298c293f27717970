package rasterlab.app.cli.exercise;

import java.nio.file.Path;
import picocli.CommandLine.Option;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.server.Account;

/** The token of a student at a grading server: given, in a file, or in the environment. */
final class TokenOption {
    /** The variable of the environment that may hold it. */
    static final String VARIABLE = "RASTERLAB_TOKEN";

    @Option(
            names = "--token",
            paramLabel = "TOKEN",
            description = "your token at that server; others on this computer may see it")
    private String given;

    @Option(
            names = "--token-file",
            paramLabel = "FILE",
            description = "file that holds the token; default: the variable RASTERLAB_TOKEN")
    private Path file;

    /**
     * The token, without what is around it.
     *
     * @throws Complaint if there is none, or what is there cannot be one; it does not tell it
     */
    String read() {
        if (given != null && file != null)
            throw Complaint.badInput("--token and --token-file cannot both be given");
        if (given != null) return token("--token", given);
        if (file != null) return token(file.toString(), FileToRead.text(file, FileKind.SETTINGS));
        String kept = System.getenv(VARIABLE);
        if (kept == null)
            throw Complaint.badInput(
                    "no token: give --token-file FILE, set "
                            + VARIABLE
                            + ", or give --token TOKEN");
        return token(VARIABLE, kept);
    }

    private static String token(String place, String text) {
        String token = text.strip();
        if (!Account.isToken(token))
            throw Complaint.badInput(
                    place + ": is not a token; one has visible ASCII characters and no spaces");
        return token;
    }
}
