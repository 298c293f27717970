package rasterlab.exercises.catalogue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Shape;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Hint;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/**
 * Reads the hints of an exercise: {@code hints.en.md} and {@code hints.ru.md}, in which each step
 * stands under its number ({@code ## 1}, {@code ## 2}, {@code ## 3}), and what each costs, from
 * {@code exercise.json}. No grade depends on their words, so they are no part of the revision.
 */
final class HintReader {
    /** The field for the points that each step costs; where it is missing, they cost nothing. */
    static final String COSTS = "hintCosts";

    private static final List<String> LANGUAGES = List.of("en", "ru");
    private static final int MOST_CHARACTERS = 1000;
    private static final Pattern HEADING = Pattern.compile("(?m)^##[ \\t]+(.*?)[ \\t]*$");
    private static final Pattern TITLE = Pattern.compile("\\s*(# [^\\n]*)?\\s*");
    private static final List<String> NUMBERS = List.of("1", "2", "3");

    private static final Field<int[]> POINTS = Field.required(COSTS, Shape.wholes(Hint.STEPS));

    private final ExerciseFolder folder;
    private final JsonFields fields;
    private final Faults faults;

    /**
     * @param fields of {@code exercise.json}
     * @param faults takes what is wrong
     */
    HintReader(ExerciseFolder folder, JsonFields fields, Faults faults) {
        this.folder = folder;
        this.fields = fields;
        this.faults = faults;
    }

    /** The name of a language's hints. */
    static String file(String language) {
        return "hints." + language + ".md";
    }

    /**
     * All steps; none where the folder has none, or something is wrong with them, which is kept.
     */
    List<Hint> read() {
        Optional<List<Integer>> costs = costs();
        if (!fields.has(COSTS) && LANGUAGES.stream().noneMatch(one -> folder.has(file(one))))
            return List.of();
        Map<String, List<String>> texts = new LinkedHashMap<>();
        for (String language : LANGUAGES)
            faults.tried(() -> folder.text(file(language)))
                    .flatMap(text -> steps(file(language), text.replace("\r\n", "\n")))
                    .ifPresent(steps -> texts.put(language, steps));
        if (costs.isEmpty() || texts.size() < LANGUAGES.size()) return List.of();
        List<Hint> hints = new ArrayList<>();
        for (int i = 0; i < Hint.STEPS; i++) {
            Map<String, String> words = new LinkedHashMap<>();
            for (String language : LANGUAGES) words.put(language, texts.get(language).get(i));
            hints.add(new Hint(words, costs.get().get(i)));
        }
        return hints;
    }

    /** The cost of each step; empty where something is wrong, all of which is kept. */
    private Optional<List<Integer>> costs() {
        if (!fields.has(COSTS)) return Optional.of(NUMBERS.stream().map(one -> 0).toList());
        if (fields.tree(COSTS).size() != Hint.STEPS || !fields.tree(COSTS).isArray())
            return faults.tried(() -> IntStream.of(fields.get(POINTS)).boxed().toList());
        List<Integer> costs = new ArrayList<>();
        for (int i = 0; i < Hint.STEPS; i++) {
            int step = i;
            faults.tried(() -> fields.member(COSTS, step, 0, Exercise.MOST_POINTS - 1))
                    .ifPresent(costs::add);
        }
        if (costs.size() < Hint.STEPS) return Optional.empty();
        return faults.tried(() -> affordable(costs));
    }

    private List<Integer> affordable(List<Integer> costs) {
        int sum = costs.stream().mapToInt(Integer::intValue).sum();
        if (sum >= Exercise.MOST_POINTS)
            throw fields.wrong(COSTS, Phrase.of("field.hints", sum, Exercise.MOST_POINTS));
        return costs;
    }

    /** The text under each number; empty where something is wrong, all of which is kept. */
    private Optional<List<String>> steps(String file, String text) {
        List<String> found = new ArrayList<>();
        List<Integer> ends = new ArrayList<>();
        List<Integer> begins = new ArrayList<>();
        for (Matcher heading = HEADING.matcher(text); heading.find(); ) {
            found.add(heading.group(1));
            ends.add(heading.start());
            begins.add(heading.end());
        }
        if (!found.equals(NUMBERS)) return wrong(file, foundPhrase(found));
        ends.add(text.length());
        int before = faults.all().size();
        if (!TITLE.matcher(text.substring(0, ends.get(0))).matches())
            wrong(file, Phrase.of("hints.before"));
        List<String> steps = new ArrayList<>();
        for (int i = 0; i < Hint.STEPS; i++) {
            String step = text.substring(begins.get(i), ends.get(i + 1)).strip();
            check(file, i + 1, step);
            steps.add(step);
        }
        return before == faults.all().size() ? Optional.of(steps) : Optional.empty();
    }

    private static Phrase foundPhrase(List<String> found) {
        return found.isEmpty()
                ? Phrase.of("hints.none")
                : Phrase.of("hints.steps", "## " + String.join(", ## ", found));
    }

    private void check(String file, int number, String step) {
        if (step.isEmpty()) wrong(file, Phrase.of("hints.empty", number));
        if (step.length() > MOST_CHARACTERS)
            wrong(file, Phrase.of("hints.long", number, step.length(), MOST_CHARACTERS));
        if (step.contains("![")) wrong(file, Phrase.of("hints.picture", number));
    }

    private <T> Optional<T> wrong(String file, Phrase reason) {
        return faults.tried(
                () -> {
                    throw new CatalogueException(
                            Phrase.of("folder.at", folder.place(file), reason));
                });
    }
}
