package rasterlab.exercises.folder;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.judging.InputJson;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.topic.TopicGradings;

/**
 * Makes the files of an exercise to begin with: inputs from the topic's hazards, texts and sources
 * with what is still to be written.
 */
public final class NewFolder {
    private static final int ACCURACY = 75;
    private static final int STABILITY = 15;
    private static final int SPEED = 10;
    private static final int MOST_OPEN = 3;
    private static final int MOST_HIDDEN = 3;

    /** The proof has every faulty method answer every case, which longer answers make slow. */
    private static final int LONGEST_ANSWER = 20_000;

    private final Topic<?, ?, ?> topic;
    private final TopicGrading grading;
    private final List<String> hazards;

    private NewFolder(String topic) {
        this.topic = Topics.named(topic);
        this.grading = TopicGradings.named(topic);
        this.hazards = answered(this.topic).stream().filter(this::isShort).toList();
    }

    /**
     * Name to text of each file.
     *
     * @param topic one of {@link TopicGradings#names}
     */
    public static Map<String, String> files(String topic) {
        return new NewFolder(topic).files();
    }

    private Map<String, String> files() {
        Map<String, String> files = new LinkedHashMap<>();
        files.put("exercise.json", exercise().toPrettyString() + "\n");
        files.put("cases.json", open().toPrettyString() + "\n");
        files.put("hidden-cases.json", hidden().toPrettyString() + "\n");
        files.put("statement.en.md", NewTexts.english(grading.contract()));
        files.put("statement.ru.md", NewTexts.russian(grading.contract()));
        files.put("hints.en.md", NewTexts.englishHints());
        files.put("hints.ru.md", NewTexts.russianHints());
        files.put("Starter.java", NewTexts.source(grading.contract(), "MyMethod"));
        files.put("Model.java", NewTexts.source(grading.contract(), "Model"));
        return files;
    }

    /** Names of the hazards that a right method answers. */
    private static <I> List<String> answered(Topic<?, I, ?> topic) {
        return topic.hazards().stream()
                .filter(one -> one.recorded().containsValue(Verdict.Kind.EXACT))
                .map(Hazard::name)
                .toList();
    }

    /** Whether a right answer to the hazard has few items. */
    private boolean isShort(String hazard) {
        String input = JsonNodeFactory.instance.objectNode().put("hazard", hazard).toString();
        Exercise.Case asked =
                new Exercise.Case(
                        hazard,
                        Map.of(),
                        Exercise.Kind.STABILITY,
                        Disclosure.VERDICT_ONLY,
                        0,
                        input,
                        false);
        try {
            return grading.calls(asked, new Exercise.Tolerance(false), 0).stream()
                    .allMatch(call -> call.items() <= LONGEST_ANSWER);
        } catch (CatalogueException tooLong) {
            return false;
        }
    }

    private ObjectNode exercise() {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("topic", topic.name());
        root.set("title", both("TITLE", "НАЗВАНИЕ"));
        root.set("tolerance", JsonNodeFactory.instance.objectNode());
        root.putObject("points")
                .put("accuracy", ACCURACY)
                .put("stability", STABILITY)
                .put("speed", SPEED);
        root.putArray("hintCosts").add(1).add(2).add(4);
        root.putObject("timed").put("count", 20).set("given", given());
        root.putArray("groups")
                .addObject()
                .put("name", "ordinary")
                .set("title", both("ordinary inputs", "обычные данные"));
        root.putArray("cases").add("cases.json").add("hidden-cases.json");
        root.put("model", "Model.java");
        List<String> notAsked = mistakesOfLongAnswers();
        if (!notAsked.isEmpty()) notAsked.forEach(root.putArray("notAsked")::add);
        return root;
    }

    /** Names of mutants whose own hazard is none of the cases, since its answer is too long. */
    private List<String> mistakesOfLongAnswers() {
        Set<String> left = new HashSet<>(answered(topic));
        hazards.forEach(left::remove);
        return topic.mutants().stream()
                .filter(one -> left.contains(one.hazard()))
                .map(Mutant::name)
                .toList();
    }

    private static ObjectNode both(String english, String russian) {
        return JsonNodeFactory.instance.objectNode().put("en", english).put("ru", russian);
    }

    /** An input as JSON, whose numbers are to be made ranges. */
    private JsonNode given() {
        return hazards.stream()
                .map(name -> InputJson.of(topic, name))
                .filter(one -> !one.isEmpty())
                .findFirst()
                .orElse(JsonNodeFactory.instance.objectNode());
    }

    private ArrayNode open() {
        List<String> names = hazards.subList(0, Math.min(MOST_OPEN, hazards.size()));
        return cases(names, "accuracy", "open", ACCURACY - hiddenAccuracy());
    }

    private int hiddenAccuracy() {
        return ACCURACY / 2;
    }

    private ArrayNode hidden() {
        int from = Math.min(MOST_OPEN, Math.max(0, hazards.size() - 1));
        List<String> names = hazards.subList(from, Math.min(from + MOST_HIDDEN, hazards.size()));
        ArrayNode cases = JsonNodeFactory.instance.arrayNode();
        ObjectNode drawn = JsonNodeFactory.instance.objectNode();
        drawn.put("name", "random-inputs");
        drawn.set("title", both("random inputs", "случайные данные"));
        drawn.put("group", "ordinary")
                .put("kind", "accuracy")
                .put("visibility", "verdict-only")
                .put("points", hiddenAccuracy());
        drawn.putObject("generate").put("count", 1).set("given", given());
        cases.add(drawn);
        cases.addAll(cases(names, "stability", "verdict-only", STABILITY));
        return cases;
    }

    private static ArrayNode cases(
            List<String> hazards, String kind, String visibility, int points) {
        ArrayNode cases = JsonNodeFactory.instance.arrayNode();
        int left = points;
        for (int i = 0; i < hazards.size(); i++) {
            int share = left / (hazards.size() - i);
            left -= share;
            String name = visibility.equals("open") ? hazards.get(i) : "hidden-" + hazards.get(i);
            ObjectNode one = cases.addObject();
            one.put("name", name);
            one.set("title", both(name.replace('-', ' '), "ВХОД " + name));
            one.put("kind", kind).put("visibility", visibility).put("points", share);
            one.putObject("input").put("hazard", hazards.get(i));
        }
        return cases;
    }
}
