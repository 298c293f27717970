package rasterlab.exercises.breaking;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.json.JsonText;
import rasterlab.exercises.json.NotJson;
import rasterlab.exercises.judging.MethodsOnInput;
import rasterlab.exercises.score.Phrase;

/**
 * Inputs that a student handed in as JSON: one object, or an array of several.
 *
 * @param inputs each as {@code ./lab run} takes it, without white space
 */
public record HandedInputs(List<String> inputs) {
    /** Characters of everything that is handed in; a longer text is refused unread. */
    public static final int MOST_CHARACTERS = 64 * 1024;

    public HandedInputs {
        inputs = List.copyOf(inputs);
    }

    /**
     * Reads what was handed in.
     *
     * @param most inputs
     * @throws CatalogueException if it is none; says of all that is wrong the place, the value and
     *     what is allowed
     */
    public static HandedInputs of(String topic, String json, int most) {
        if (json.length() > MOST_CHARACTERS)
            throw new CatalogueException(Phrase.of("break.long", json.length(), MOST_CHARACTERS));
        JsonNode tree = tree(json);
        if (!tree.isArray()) return new HandedInputs(List.of(checked(topic, 0, tree)));
        if (tree.isEmpty() || tree.size() > most)
            throw new CatalogueException(Phrase.of("break.count", tree.size(), most));
        List<String> inputs = new ArrayList<>();
        var faults = new Faults();
        for (int i = 0; i < tree.size(); i++) {
            int number = i + 1;
            faults.tried(() -> checked(topic, number, tree.get(number - 1))).ifPresent(inputs::add);
        }
        faults.requireNoneOfAll();
        return new HandedInputs(inputs);
    }

    private static JsonNode tree(String json) {
        try {
            return JsonText.treeWithAllDigits(json);
        } catch (NotJson e) {
            throw new CatalogueException(
                    Phrase.of(
                            "field.wrong",
                            Phrase.of("break.input"),
                            Phrase.of("json.not", e.phrase())),
                    e);
        }
    }

    /**
     * @param number from 1; 0 for an only one
     */
    private static String checked(String topic, int number, JsonNode input) {
        Phrase place = number == 0 ? Phrase.of("break.input") : Phrase.of("break.input.of", number);
        String json = input.toString();
        MethodsOnInput.of(topic, place, json);
        return json;
    }

    /** Characters of all inputs together, without white space. */
    public int characters() {
        return inputs.stream().mapToInt(String::length).sum();
    }
}
