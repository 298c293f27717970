package rasterlab.app.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.outcome.ExitCode;

/** {@code ./lab} itself: help and version; the window is opened before this is reached. */
@Command(
        name = "./lab",
        mixinStandardHelpOptions = true,
        versionProvider = LabVersion.class,
        header = "Rasterlab: see, measure and break the algorithms of computer graphics.",
        description = "Without a command the desktop lab opens, with --lang in that language.",
        synopsisSubcommandLabel = "COMMAND",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:done",
            "1:done, and something was found wrong (hazards, check, submit, prove, study, tour)",
            "2:the command line or the input is wrong; one line says where",
            "3:the method refuses this input",
            "4:no answer: the method crashed, did not end, or its answer is over a limit; for submit: the"
                    + " server cannot be reached, or accepts no more at the moment",
            "70:a fault of Rasterlab; the message names a log file"
        },
        footer = {
            "",
            "`./lab help COMMAND` shows a command's options and an example.",
            "Example: echo '{\"from\":[0,0],\"to\":[5,2]}' | ./lab run line bresenham"
        })
final class LabCommand implements Callable<Integer> {
    static final String LANGUAGE = "--lang";

    private final Console console;
    @Spec private CommandSpec spec;

    /**
     * The option of every command; what it says is known before the words are read, so this checks
     * it only.
     */
    @Option(
            names = LANGUAGE,
            paramLabel = "LANGUAGE",
            scope = ScopeType.INHERIT,
            description =
                    "language of messages and pictures: en or ru; default: en. Names, JSON and CSV"
                            + " are the same in both")
    private ReportLanguage language = ReportLanguage.EN;

    LabCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        spec.commandLine().usage(console.out());
        return ExitCode.DONE;
    }
}
