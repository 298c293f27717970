package rasterlab.exercises.predicting;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.Asked;
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
     * @throws CatalogueException if it is no such sheet; says the place, the value and what is
     *     allowed
     */
    public static HandedAnswers of(Exercise exercise, String json) {
        if (json.length() > MOST_CHARACTERS)
            throw new CatalogueException(Phrase.of("break.long", json.length(), MOST_CHARACTERS));
        Predicting rules = exercise.predicting().orElseThrow();
        JsonFields fields =
                JsonFields.parse(
                        Phrase.of("predict.sheet"), json, "exercise", SEED, "questions", ANSWERS);
        fields.word("exercise", List.of(exercise.id()), exercise.id());
        long seed = seed(fields);
        Sheet sheet = Sheet.of(exercise.topic(), rules, seed);
        return new HandedAnswers(sheet, answers(fields, sheet, rules));
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

    private static List<JsonNode> answers(JsonFields fields, Sheet sheet, Predicting rules) {
        String[] known =
                Stream.concat(Stream.of(NUMBER), rules.asked().stream().map(Asked::field))
                        .toArray(String[]::new);
        fields.tree(ANSWERS);
        List<JsonFields> given = fields.objects(ANSWERS, known);
        if (given.size() > sheet.questions().size())
            throw fields.wrong(
                    ANSWERS, Phrase.of("predict.count", given.size(), sheet.questions().size()));
        List<JsonNode> answers = new ArrayList<>();
        for (JsonFields one : given) {
            int number = answers.size() + 1;
            if (one.has(NUMBER)) one.integer(NUMBER, number, number);
            for (Asked asked : rules.asked())
                if (one.has(asked.field()))
                    check(one, asked, sheet.questions().get(number - 1).right());
            answers.add(one.tree());
        }
        while (answers.size() < sheet.questions().size()) answers.add(MissingNode.getInstance());
        return answers;
    }

    private static void check(JsonFields answer, Asked asked, JsonNode right) {
        JsonNode value = answer.tree(asked.field());
        JsonNode expected = right.path(asked.field());
        if (value.isNull()) return;
        if (!asked.words().isEmpty()) {
            answer.word(asked.field(), asked.words());
            return;
        }
        if (!StepValues.isOfForm(expected, value))
            throw answer.wrong(
                    asked.field(),
                    expected.isBoolean()
                            ? Phrase.of("field.flag", shown(value))
                            : expected.isArray()
                                    ? Phrase.of("predict.form", StepValues.form(expected), shown(value))
                                    : Phrase.of("predict.number", shown(value)));
    }

    private static String shown(JsonNode value) {
        String text = value.toString();
        return text.length() <= 60 ? text : text.substring(0, 60) + "…";
    }
}
