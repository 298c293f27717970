package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import rasterlab.app.language.Texts;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.predicting.StepText;

/** Tells in words what the picture shows: the input, and the steps that are made. */
final class WalkText {
    private WalkText() {}

    /** The input of a walk as JSON. */
    static JsonNode input(String json) {
        try {
            return OwnJson.MAPPER.readTree(json);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A line for each part of the input, and one for each step. */
    static String of(PracticeState state, Texts texts) {
        var words = new StepText(state.topic().orElseThrow(), texts.locale());
        var text = new StringBuilder(texts.text("walk.input"));
        input(state.question().input())
                .properties()
                .forEach(
                        one ->
                                text.append("\n  ")
                                        .append(words.part(one.getKey(), one.getValue())));
        text.append("\n\n").append(texts.text("walk.steps"));
        for (int i = 0; i < state.steps().size(); i++)
            text.append("\n  ")
                    .append(i + 1)
                    .append(".  ")
                    .append(words.fieldsText(state.question().shown(state.steps().get(i))));
        if (state.steps().isEmpty()) text.append("\n  ").append(texts.text("walk.none"));
        return StepText.signed(text.toString());
    }
}
