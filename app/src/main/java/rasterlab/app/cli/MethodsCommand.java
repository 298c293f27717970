package rasterlab.app.cli;

import java.io.PrintStream;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.cli.run.Runs;
import rasterlab.app.cli.run.TopicRun;
import rasterlab.app.outcome.ExitCode;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** Lists topics, their methods and hazards. */
@Command(
        name = "methods",
        mixinStandardHelpOptions = true,
        description = {
            "Lists topics with their methods and hazards,",
            "and what `./lab run` reads and answers for them as JSON."
        },
        footer = {"", "Example: ./lab methods line"})
final class MethodsCommand implements Callable<Integer> {
    private static final int WIDTH = 100;

    private final Console console;

    @Parameters(arity = "0..1", paramLabel = "TOPIC", description = "only this one")
    private String topic;

    MethodsCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        TopicChoice.of(topic).forEach(this::print);
        return ExitCode.DONE;
    }

    private void print(Topic<?, ?, ?> topic) {
        PrintStream out = console.out();
        out.println("topic " + topic.name());
        out.println();
        TopicRun.Form form = Runs.named(topic.name()).form();
        printWrapped("  reads:   ", form.input());
        printWrapped("  answers: ", form.answer());
        out.println();
        for (Method<?> method : topic.methods()) {
            out.println("  method " + method.name());
            printWrapped("    computes: ", method.about().formula());
            printWrapped("    costs:    ", method.about().cost());
            printWrapped("    fails:    ", method.about().failures());
            out.println();
        }
        if (!topic.vocabulary().isEmpty()) printVocabulary(topic);
        var hazards = new TextTable("hazard", "what is special");
        for (Hazard<?> hazard : topic.hazards())
            hazards.add(List.of(hazard.name(), hazard.description()));
        hazards.lines().forEach(line -> out.println("  " + line));
    }

    /** One label, the lines of the text below each other behind it. */
    private void printWrapped(String label, String text) {
        String start = label;
        for (String line : Wrapping.lines(text, WIDTH - label.length(), String::length)) {
            console.out().println(start + line);
            start = " ".repeat(label.length());
        }
    }

    private void printVocabulary(Topic<?, ?, ?> topic) {
        var words = new TextTable("name", "meaning");
        topic.vocabulary().forEach((word, meaning) -> words.add(List.of(word, meaning)));
        words.lines().forEach(line -> console.out().println("  " + line));
        console.out().println();
    }
}
