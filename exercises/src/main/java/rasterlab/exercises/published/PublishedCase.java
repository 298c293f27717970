package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.PublishedVerdict;
import rasterlab.exercises.topic.CaseRules.CaseRule;

/**
 * A judged case.
 *
 * @param verdict with its code; {@code no_result} where the method was stopped before the case's
 *     turn came
 * @param message in words, with the signs of people
 * @param messageInJson the same as JSON has it
 * @param place in the answer that the message tells in words, as a path of its JSON; empty where it
 *     tells none
 * @param tolerance how exactly an answer is compared with the right one; empty for what is no case
 * @param rule on ties, borders or the order of what is answered; empty where there is none
 * @param scene the case as a scene file; "" where there is none
 * @param why the case is there, of a hidden one that may be seen whole; empty where that is not
 *     told
 */
public record PublishedCase(
        String name,
        String title,
        String visibility,
        PublishedVerdict verdict,
        int points,
        int of,
        String message,
        String messageInJson,
        Optional<String> place,
        Optional<String> tolerance,
        Optional<String> rule,
        List<PublishedPicture> pictures,
        String scene,
        Optional<String> why)
        implements PublishedPart {
    public PublishedCase {
        pictures = List.copyOf(pictures);
    }

    /**
     * A case in words of that language.
     *
     * @param language such as "ru"
     * @param title in that language
     * @param url of a picture of the case
     */
    public static PublishedCase of(
            CaseReport judged, String language, String title, Function<CasePicture, String> url) {
        return new PublishedCase(
                judged.name(),
                title,
                judged.visibility().code(),
                PublishedVerdict.of(judged.verdict()),
                judged.points(),
                judged.of(),
                judged.message(language),
                judged.messageInJson(language),
                judged.place(),
                Optional.empty(),
                Optional.empty(),
                judged.pictures().stream()
                        .map(one -> PublishedPicture.of(one, language, url.apply(one)))
                        .toList(),
                judged.scene(),
                Optional.empty());
    }

    /**
     * This case with the reason why the case is there.
     *
     * @param reason in the language of the other words
     */
    public PublishedCase because(String reason) {
        return with(tolerance, rule, Optional.of(reason));
    }

    /** This case with what makes an answer right, in that language. */
    public PublishedCase under(CaseRule right, String language) {
        return with(
                Optional.of(right.tolerance().in(language)),
                Optional.of(right.rule().in(language)).filter(told -> !told.isEmpty()),
                why);
    }

    private PublishedCase with(
            Optional<String> newTolerance, Optional<String> newRule, Optional<String> newWhy) {
        return new PublishedCase(
                name,
                title,
                visibility,
                verdict,
                points,
                of,
                message,
                messageInJson,
                place,
                newTolerance,
                newRule,
                pictures,
                scene,
                newWhy);
    }

    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeStringField("name", name);
        out.writeStringField("title", title);
        out.writeStringField("visibility", visibility);
        out.writeBooleanField("run", verdict.run());
        out.writeStringField("verdict", verdict.code());
        out.writeNumberField("points", points);
        out.writeNumberField("of", of);
        out.writeStringField("message", messageInJson);
        out.writeStringField("place", place.orElse(null));
        out.writeStringField("tolerance", tolerance.orElse(null));
        out.writeStringField("rule", rule.orElse(null));
        out.writeArrayFieldStart("pictures");
        for (PublishedPicture one : pictures) one.write(out);
        out.writeEndArray();
        out.writeFieldName("scene");
        if (scene.isEmpty()) out.writeNull();
        else out.writeRawValue(scene.strip());
        if (why.isPresent()) out.writeStringField("why", why.get());
        out.writeEndObject();
    }
}
