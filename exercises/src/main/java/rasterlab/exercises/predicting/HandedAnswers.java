package rasterlab.exercises.predicting;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.PredictedField;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/**
 * A sheet that a student handed in.
 *
 * @param sheet the one that its seed draws
 * @param answers one for each question; a missing node where there is none
 */
public record HandedAnswers(Sheet sheet, List<JsonNode> answers) {
    /** Characters of everything that is handed in; a longer text is refused unread. */
    public static final int MOST_CHARACTERS = 64 * 1024;

    static final String NUMBER = "question";
    private static final String SEED = "seed";
    private static final String ANSWERS = "answers";

    public HandedAnswers {
        answers = List.copyOf(answers);
    }

    /**
     * Reads what was handed in for an exercise that asks for predictions.
     *
     * @throws CatalogueException if it is no such sheet; says of all that is wrong the place, the
     *     value and what is allowed
     */
    public static HandedAnswers of(Exercise exercise, String json) {
        if (json.length() > MOST_CHARACTERS)
            throw new CatalogueException(Phrase.of("break.long", json.length(), MOST_CHARACTERS));
        Predicting rules = exercise.predicting().orElseThrow();
        var faults = new Faults();
        JsonFields fields =
                JsonFields.parse(Phrase.of("predict.sheet"), json).keeping(faults::keep);
        faults.checkKnown(fields, "exercise", SEED, "questions", ANSWERS);
        faults.checked(() -> fields.word("exercise", List.of(exercise.id()), exercise.id()));
        Optional<Sheet> sheet = faults.tried(() -> Sheet.of(exercise.topic(), rules, seed(fields)));
        faults.checked(() -> fields.tree(ANSWERS));
        List<JsonNode> answers = new Answers(rules, sheet, faults).read(fields);
        faults.requireNoneOfAll();
        return new HandedAnswers(sheet.orElseThrow(), answers);
    }

    /** Whether any question has an answer. */
    public boolean isAnswered() {
        for (int i = 0; i < answers.size(); i++)
            for (PredictedField asked : sheet.questions().get(i).rules().asked())
                if (answers.get(i).hasNonNull(asked.field())) return true;
        return false;
    }

    private static long seed(JsonFields fields) {
        JsonNode seed = fields.tree(SEED);
        if (!seed.isIntegralNumber()
                || !seed.canConvertToLong()
                || seed.longValue() < 0
                || seed.longValue() > Sheet.MOST_SEED)
            throw fields.wrong(
                    SEED, Phrase.of("predict.seed", String.valueOf(Sheet.MOST_SEED), shown(seed)));
        return seed.longValue();
    }

    /**
     * Reads the answers one by one.
     *
     * @param sheet tells the form of the answers; empty where its seed cannot be read
     */
    private record Answers(Predicting rules, Optional<Sheet> sheet, Faults faults) {
        List<JsonNode> read(JsonFields fields) {
            String[] known =
                    Stream.concat(
                                    Stream.of(NUMBER),
                                    rules.asked().stream().map(PredictedField::field))
                            .toArray(String[]::new);
            List<JsonNode> answers = new ArrayList<>();
            for (Optional<JsonFields> one : given(fields, known)) {
                int number = answers.size() + 1;
                one.ifPresent(answer -> check(answer, number));
                answers.add(one.map(JsonFields::tree).orElse(MissingNode.getInstance()));
            }
            while (answers.size() < rules.steps()) answers.add(MissingNode.getInstance());
            return answers;
        }

        /** The answers, each empty where it is no object; none where there are too many. */
        private List<Optional<JsonFields>> given(JsonFields fields, String... known) {
            JsonNode given = fields.has(ANSWERS) ? fields.tree(ANSWERS) : MissingNode.getInstance();
            if (given.size() > rules.steps()) {
                faults.keep(
                        fields.wrong(
                                ANSWERS, Phrase.of("predict.count", given.size(), rules.steps())));
                return List.of();
            }
            if (!given.isArray()) faults.checked(() -> fields.objects(ANSWERS, known));
            List<Optional<JsonFields>> objects = new ArrayList<>();
            for (int i = 0; given.isArray() && i < given.size(); i++) {
                int index = i;
                objects.add(faults.tried(() -> fields.object(ANSWERS, index, known)));
            }
            return objects;
        }

        private void check(JsonFields answer, int number) {
            if (answer.has(NUMBER)) faults.checked(() -> answer.integer(NUMBER, number, number));
            for (PredictedField asked : rules.asked())
                if (answer.has(asked.field())) faults.checked(() -> check(answer, asked, number));
        }

        private void check(JsonFields answer, PredictedField asked, int number) {
            JsonNode value = answer.tree(asked.field());
            if (value.isNull()) return;
            if (!asked.words().isEmpty()) {
                answer.word(asked.field(), asked.words());
                return;
            }
            if (sheet.isEmpty()) return;
            JsonNode right = sheet.get().questions().get(number - 1).right();
            JsonNode expected = right.path(asked.field());
            if (!StepValues.isOfForm(expected, value))
                throw answer.wrong(asked.field(), form(expected, value));
        }

        private static Phrase form(JsonNode expected, JsonNode value) {
            if (expected.isBoolean()) return Phrase.of("field.flag", shown(value));
            return expected.isArray()
                    ? Phrase.of("predict.form", StepValues.form(expected), shown(value))
                    : Phrase.of("predict.number", shown(value));
        }
    }

    private static String shown(JsonNode value) {
        String text = value.toString();
        return text.length() <= 60 ? text : text.substring(0, 60) + "…";
    }
}
