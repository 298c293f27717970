package rasterlab.app.cli;

import java.io.PrintStream;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import rasterlab.app.outcome.ExitCode;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** Lists topics, their methods and hazards. */
@Command(
        name = "methods",
        mixinStandardHelpOptions = true,
        description = "Lists topics with their methods and hazards.",
        footer = {"", "Example: ./lab methods line"})
final class MethodsCommand implements Callable<Integer> {
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
        for (Method<?> method : topic.methods()) {
            out.println("  method " + method.name());
            out.println("    computes: " + method.about().formula());
            out.println("    fails:    " + method.about().failures());
        }
        out.println();
        if (!topic.vocabulary().isEmpty()) printVocabulary(topic);
        var hazards = new TextTable("hazard", "what is special");
        for (Hazard<?> hazard : topic.hazards())
            hazards.add(List.of(hazard.name(), hazard.description()));
        hazards.lines().forEach(line -> out.println("  " + line));
    }

    private void printVocabulary(Topic<?, ?, ?> topic) {
        var words = new TextTable("name", "meaning");
        topic.vocabulary().forEach((word, meaning) -> words.add(List.of(word, meaning)));
        words.lines().forEach(line -> console.out().println("  " + line));
        console.out().println();
    }
}
