package rasterlab.app.cli.study;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.cli.run.ProgramJson;
import rasterlab.app.cli.run.TopicRunner;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.TopicSchema;

/** Lists topics, their methods and hazards. */
@Command(
        name = "methods",
        mixinStandardHelpOptions = true,
        description = {
            "Lists topics with their methods and hazards.",
            "Says of each what `./lab run` reads and answers for it as JSON."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:the topics were listed", "2:there is no such topic"},
        footer = {"", "Example: ./lab methods line"})
public final class MethodsCommand implements Callable<Integer> {
    private static final int WIDTH = 100;
    private static final String[] ABOUT = {"computes", "costs", "fails"};

    private final Console console;
    private final Texts texts;

    @Parameters(arity = "0..1", paramLabel = "TOPIC", description = "only this one")
    private String topic;

    @Option(
            names = "--schema",
            description = {
                "prints a JSON Schema (draft 2020-12) of what `./lab run` reads for TOPIC;",
                "$defs has it as input, and as output what is answered"
            })
    private boolean schema;

    public MethodsCommand(Console console) {
        this.console = console;
        texts = console.language().texts();
    }

    @Override
    public Integer call() throws IOException {
        if (schema) printSchema();
        else TopicChoice.of(topic).forEach(this::print);
        return ExitCode.DONE;
    }

    private void printSchema() throws IOException {
        if (topic == null) throw Complaint.badInput("--schema needs TOPIC; see `./lab methods`");
        Topic<?, ?, ?> one = TopicChoice.one(topic);
        JsonGenerator json =
                new JsonFactory()
                        .createGenerator(console.out())
                        .disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET)
                        .useDefaultPrettyPrinter();
        json.writeStartObject();
        TopicSchema.write(one.format(), new ProgramJson(json));
        json.writeEndObject();
        json.writeRaw('\n');
        json.close();
    }

    private void print(Topic<?, ?, ?> topic) {
        PrintStream out = console.out();
        TopicTexts said = TopicTexts.of(topic.name(), console.language().inWindow());
        out.println(texts.text("topic") + " " + topic.name());
        out.println();
        var forms = new FormWords(console.language().inWindow());
        TopicRunner<?> run = TopicRunner.named(topic.name());
        printWrapped(label("  ", "reads", "reads", "answers"), forms.reads(run));
        printWrapped(label("  ", "answers", "reads", "answers"), forms.answers(run));
        out.println();
        for (Method<?> method : topic.methods()) {
            out.println("  " + texts.text("method") + " " + method.name());
            printWrapped(label("    ", "computes", ABOUT), said.about(method, "formula"));
            printWrapped(label("    ", "costs", ABOUT), said.about(method, "cost"));
            printWrapped(label("    ", "fails", ABOUT), said.about(method, "failures"));
            out.println();
        }
        Map<String, String> vocabulary = forms.vocabulary(topic);
        if (!vocabulary.isEmpty()) printVocabulary(vocabulary);
        var hazards = new TextTable(texts.text("hazard"), texts.text("special"));
        for (Hazard<?> hazard : topic.hazards())
            hazards.add(List.of(hazard.name(), said.hazard(hazard)));
        hazards.lines().forEach(line -> out.println("  " + line));
    }

    /**
     * @param all keys of the labels that the texts stand behind in one column
     */
    private String label(String before, String key, String... all) {
        int width = Stream.of(all).mapToInt(one -> texts.text(one).length()).max().orElseThrow();
        return before + texts.text(key) + " ".repeat(width + 1 - texts.text(key).length());
    }

    /** Prints a label and, behind it, the lines of the text below each other. */
    private void printWrapped(String label, String text) {
        String start = label;
        for (String line : Wrapping.lines(text, WIDTH - label.length(), String::length)) {
            console.out().println(start + line);
            start = " ".repeat(label.length());
        }
    }

    private void printVocabulary(Map<String, String> vocabulary) {
        var words = new TextTable(texts.text("name"), texts.text("meaning"));
        vocabulary.forEach((word, meaning) -> words.add(List.of(word, meaning)));
        words.lines().forEach(line -> console.out().println("  " + line));
        console.out().println();
    }
}
