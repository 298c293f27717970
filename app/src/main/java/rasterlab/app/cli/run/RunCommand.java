package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.Failures;
import rasterlab.app.language.Complaints;
import rasterlab.app.model.SceneText;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.engine.format.Written;
import rasterlab.exercises.scene.MethodCase;

/** Runs one method on JSON input. */
@Command(
        name = "run",
        mixinStandardHelpOptions = true,
        description = {
            "Runs one method on JSON from standard input and prints JSON.",
            "What a topic reads and answers as JSON is said by `./lab methods TOPIC`."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:answered; with --lines, all input was read",
            "2:unknown topic, method or hazard, or the input is wrong",
            "3:the method refuses this input",
            "4:the method crashed, did not end, or its answer is over the limit"
        },
        footer = {
            "",
            "Example: echo '{\"from\":[0,0],\"to\":[5,2]}' | ./lab run line bresenham --steps"
        })
public final class RunCommand implements Callable<Integer> {
    /** The most bytes of one input: 64 MiB. */
    private static final int LONGEST_INPUT = 64 << 20;

    private final Console console;
    private final JsonFactory json = new JsonFactory();

    @Parameters(
            index = "0..1",
            arity = "0..2",
            paramLabel = "TOPIC METHOD",
            hideParamSyntax = true,
            description = "such as line bresenham; see `./lab methods TOPIC`")
    private List<String> names = List.of();

    @Option(
            names = "--scene",
            paramLabel = "FILE",
            description = "takes topic, method and input from a scene file; METHOD may differ")
    private Path scene;

    @Option(
            names = "--hazard",
            paramLabel = "NAME",
            description = {
                "takes that hazard's input, one that `./lab methods TOPIC` lists;",
                "where it is several inputs, each is answered with one line"
            })
    private String hazard;

    @Option(
            names = "--steps",
            description =
                    "adds each step; where a method decides by a value, that value and its formula")
    private boolean steps;

    @Option(
            names = "--lines",
            description = {
                "reads one JSON object per line and answers each with one line, in order;",
                "a refused line is answered with {\"error\":\"...\"}"
            })
    private boolean lines;

    public RunCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        if (hazard != null && (lines || scene != null))
            throw Complaint.badInput(
                    "--hazard NAME goes with TOPIC and METHOD, and not with --lines or --scene");
        return scene == null ? runNamed() : runScene();
    }

    private int runNamed() throws IOException {
        if (names.size() < 2)
            throw Complaint.badInput(
                    "needs TOPIC and METHOD, or --scene FILE; see `./lab methods`");
        TopicRunner<?> run = TopicRunner.named(names.get(0));
        String method = names.get(1);
        run.requireMethod(method);
        try (var generator = generator()) {
            if (hazard != null) answerHazard(run, method, generator);
            else if (lines) answerLines(run, method, generator);
            else answerWhole(run, method, read(), generator);
        }
        return ExitCode.DONE;
    }

    private int runScene() throws IOException {
        if (lines || names.size() > 1)
            throw Complaint.badInput("--scene FILE goes with METHOD alone, and not with --lines");
        MethodCase one = SceneText.methodCase(scene);
        TopicRunner<?> run = TopicRunner.named(one.topic());
        String method =
                names.stream()
                        .findFirst()
                        .or(one::method)
                        .orElseThrow(
                                () ->
                                        Complaint.badInput(
                                                scene + ": names no method; give one: METHOD"));
        run.requireMethod(method);
        try (var generator = generator()) {
            answerWhole(run, method, one.input().getBytes(StandardCharsets.UTF_8), generator);
        }
        return ExitCode.DONE;
    }

    private JsonGenerator generator() throws IOException {
        var generator =
                json.createGenerator(new BufferedOutputStream(console.out(), 1 << 16))
                        .disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET)
                        .disable(JsonGenerator.Feature.AUTO_CLOSE_JSON_CONTENT);
        generator.setRootValueSeparator(null);
        return generator;
    }

    private void answerWhole(TopicRunner<?> run, String method, byte[] text, JsonGenerator out)
            throws IOException {
        if (text.length > LONGEST_INPUT) throw tooLong("the input");
        writeLine(out, run.answer(method, text, text.length, steps));
    }

    private void answerHazard(TopicRunner<?> run, String method, JsonGenerator out)
            throws IOException {
        for (Written answer : run.answerHazard(method, hazard, steps)) writeLine(out, answer);
    }

    private byte[] read() {
        try {
            return console.in().readNBytes(LONGEST_INPUT + 1);
        } catch (IOException e) {
            throw Complaint.badInput("standard input cannot be read: " + e.getMessage());
        }
    }

    private void answerLines(TopicRunner<?> run, String method, JsonGenerator out)
            throws IOException {
        var input = new InputLines(console.in(), LONGEST_INPUT);
        while (input.next()) {
            writeLine(out, answered(run, method, input));
            if (input.drained()) flush(out);
            if (console.out().checkError()) return;
        }
    }

    private Written answered(TopicRunner<?> run, String method, InputLines input) {
        try {
            if (input.tooLong()) throw tooLong("the line");
            if (input.blank())
                throw Complaint.badInput("the line is empty; expected a JSON object");
            return run.answer(method, input.bytes(), input.length(), steps);
        } catch (Complaint complaint) {
            String said = Complaints.saidToProgram(complaint.getMessage());
            String error = Failures.oneLine(said);
            return out -> out.text("error", error);
        }
    }

    private static Complaint tooLong(String what) {
        return Complaint.badInput(what + " is longer than " + LONGEST_INPUT + " bytes");
    }

    private static void writeLine(JsonGenerator out, Written answer) throws IOException {
        out.writeStartObject();
        answer.write(new ProgramJson(out));
        out.writeEndObject();
        out.writeRaw('\n');
    }

    private void flush(JsonGenerator out) throws IOException {
        out.flush();
        console.out().flush();
    }
}
