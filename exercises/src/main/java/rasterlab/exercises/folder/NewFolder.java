package rasterlab.exercises.folder;

import static java.util.Comparator.comparing;
import static java.util.stream.Collectors.toSet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.stream.Stream;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.judging.InputJson;
import rasterlab.exercises.proving.GradedMethod;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.topic.TopicGradings;
import rasterlab.exercises.words.TopicWords;

/**
 * Makes the files of an exercise to begin with: inputs from the topic's hazards, texts and sources
 * with what is still to be written.
 */
public final class NewFolder {
    private static final Locale RUSSIAN = Locale.forLanguageTag("ru");
    private static final int ACCURACY = 75;
    private static final int STABILITY = 15;
    private static final int SPEED = 10;
    private static final int LEAST = 4;
    private static final int MOST_HIDDEN = 3;

    private static final Set<Verdict.Kind> WRONG =
            Set.of(Verdict.Kind.WRONG, Verdict.Kind.DEGRADED, Verdict.Kind.ENDLESS);

    /** The proof has every faulty method answer every case, which longer answers make slow. */
    private static final int LONGEST_ANSWER = 20_000;

    private final Topic<?, ?, ?> topic;
    private final TopicGrading grading;

    /** The hazards with a short answer. */
    private final List<String> hazards;

    /** The hazards that cases ask for, the ones that pay nothing first. */
    private final List<String> chosen;

    /** The hazards on which the starter, which does nothing, is right. */
    private final Set<String> free;

    private NewFolder(String topic) {
        this.topic = Topics.named(topic);
        this.grading = TopicGradings.named(topic);
        this.hazards =
                answered(this.topic).stream().filter(this::isTold).filter(this::isShort).toList();
        List<String> all = chosen(this.topic);
        this.free =
                all.stream()
                        .filter(name -> calls(name).stream().allMatch(this::isRightForNothing))
                        .collect(toSet());
        this.chosen = all.stream().sorted(comparing(name -> !free.contains(name))).toList();
    }

    /** The hazards that are there for known mistakes, and others until there are enough. */
    private <C, I> List<String> chosen(Topic<C, I, ?> known) {
        Set<String> names = new HashSet<>();
        for (Mutant<C> one : known.mutants())
            if (hazards.contains(one.hazard())) names.add(one.hazard());
        for (Method<C> one : known.methods())
            if (one.faulty()) showing(known, one).ifPresent(names::add);
        for (String one : hazards) if (names.size() < LEAST) names.add(one);
        return hazards.stream().filter(names::contains).toList();
    }

    /** The first hazard to which a faulty method gives a wrong answer. */
    private Optional<String> showing(Topic<?, ?, ?> known, Method<?> faulty) {
        return known.hazards().stream()
                .filter(one -> hazards.contains(one.name()))
                .filter(one -> WRONG.contains(verdict(one, faulty)))
                .map(Hazard::name)
                .findFirst();
    }

    private static Verdict.Kind verdict(Hazard<?> hazard, Method<?> method) {
        return hazard.recorded().getOrDefault(method.name(), Verdict.Kind.EXACT);
    }

    private boolean isRightForNothing(TopicGrading.GradedCall call) {
        return call.check(GradedMethod.answer(call, Nothing.of(grading.contract()))).right();
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
        files.put("statement.en.md", NewTexts.english(title(Locale.ENGLISH), grading.contract()));
        files.put("statement.ru.md", NewTexts.russian(title(RUSSIAN), grading.contract()));
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

    /** Whether the input has a form outside, in which a lab opens it. */
    private boolean isTold(String hazard) {
        return !InputJson.singles(topic, hazard).isEmpty();
    }

    /** A hazard by its name, or where it is several inputs by all of them. */
    private ObjectNode input(String hazard) {
        ObjectNode input = JsonNodeFactory.instance.objectNode();
        if (InputJson.isWhole(topic, hazard)) return input.put("hazard", hazard);
        InputJson.singles(topic, hazard).forEach(input.putArray("given")::add);
        return input;
    }

    /** Whether a right answer to the hazard has few items. */
    private boolean isShort(String hazard) {
        try {
            return calls(hazard).stream().allMatch(call -> call.items() <= LONGEST_ANSWER);
        } catch (CatalogueException tooLong) {
            return false;
        }
    }

    private List<TopicGrading.GradedCall> calls(String hazard) {
        String input = input(hazard).toString();
        Exercise.Case asked =
                new Exercise.Case(
                        hazard,
                        Map.of(),
                        Exercise.Criterion.STABILITY,
                        Disclosure.VERDICT_ONLY,
                        0,
                        input,
                        false);
        return grading.calls(asked, new Exercise.ExerciseTolerance(false), 0);
    }

    private ObjectNode exercise() {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("topic", topic.name());
        root.set("title", both(title(Locale.ENGLISH), title(RUSSIAN)));
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
                .filter(one -> chosen.stream().noneMatch(name -> tells(name, one)))
                .map(Mutant::name)
                .toList();
    }

    /** Whether the mistake is told by its name on a hazard that is there for another one. */
    private boolean tells(String hazard, Mutant<?> mistake) {
        return calls(hazard).stream()
                .map(call -> call.check(GradedMethod.answer(call, mistake.implementation())))
                .flatMap(finding -> finding.explanations().stream())
                .anyMatch(causes -> Cause.codes(causes).contains(mistake.name()));
    }

    private String title(Locale language) {
        return TopicWords.of(topic.name(), language).getString("title");
    }

    /**
     * The name of something in the words about the topic; the same for both languages where they
     * have none.
     */
    private ObjectNode titles(String key, String otherwise) {
        return both(word(key, Locale.ENGLISH, otherwise), word(key, RUSSIAN, otherwise));
    }

    private String word(String key, Locale language, String otherwise) {
        ResourceBundle words = TopicWords.of(topic.name(), language);
        return words.containsKey(key) ? words.getString(key) : otherwise;
    }

    private static ObjectNode both(String english, String russian) {
        return JsonNodeFactory.instance.objectNode().put("en", english).put("ru", russian);
    }

    /** An input as JSON, whose numbers are to be made ranges. */
    private JsonNode given() {
        return Stream.concat(chosen.stream(), hazards.stream())
                .filter(name -> !free.contains(name))
                .map(name -> InputJson.of(topic, name))
                .filter(one -> !one.isEmpty())
                .findFirst()
                .orElse(JsonNodeFactory.instance.objectNode());
    }

    private ArrayNode open() {
        return cases(
                chosen.subList(0, chosen.size() - hiddenHazards()),
                "accuracy",
                "open",
                ACCURACY - hiddenAccuracy());
    }

    /** The number of those at the end that are kept from students. */
    private int hiddenHazards() {
        int paying = chosen.size() - free.size();
        return Math.max(1, Math.min(MOST_HIDDEN, paying / 2));
    }

    private int hiddenAccuracy() {
        return ACCURACY / 2;
    }

    private ArrayNode hidden() {
        List<String> names = chosen.subList(chosen.size() - hiddenHazards(), chosen.size());
        ArrayNode cases = JsonNodeFactory.instance.arrayNode();
        ObjectNode drawn = JsonNodeFactory.instance.objectNode();
        drawn.put("name", "random-inputs");
        drawn.set("title", both("random inputs", "случайные данные"));
        drawn.put("group", "ordinary")
                .put("kind", "accuracy")
                .put("visibility", "after-deadline")
                .put("points", hiddenAccuracy());
        drawn.putObject("generate").put("count", 1).set("given", given());
        cases.add(drawn);
        cases.addAll(cases(names, "stability", "after-deadline", STABILITY));
        return cases;
    }

    /** Who does nothing earns nothing: of the points, cases have shares where that is wrong. */
    private ArrayNode cases(List<String> hazards, String kind, String visibility, int points) {
        ArrayNode cases = JsonNodeFactory.instance.arrayNode();
        int left = points;
        long paying = hazards.stream().filter(name -> !free.contains(name)).count();
        for (String hazard : hazards) {
            int share = free.contains(hazard) ? 0 : (int) (left / paying--);
            left -= share;
            String name = visibility.equals("open") ? hazard : "hidden-" + hazard;
            ObjectNode one = cases.addObject();
            one.put("name", name);
            one.set("title", titles("label." + hazard, name.replace('-', ' ')));
            one.put("kind", kind).put("visibility", visibility).put("points", share);
            one.set("input", input(hazard));
        }
        return cases;
    }
}
