package rasterlab.app.canvas;

import java.util.Optional;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.Topics;

/** Words of the labs on the user's own program, which is a method without words of a teacher's. */
public final class OwnWords {
    private OwnWords() {}

    /** A method as labs call it: by its name, or as the user's own program. */
    public static String called(String method, Language language) {
        return method.equals(OwnMethods.NAME)
                ? Texts.of("canvas", language).text("method.mine")
                : method;
    }

    /**
     * The method that a command names which runs outside of the window, where the user's program is
     * not known: the method beside it stands for it, or where there is none a right one.
     *
     * @param beside a second method; "" for none
     * @param topic of both
     */
    public static String known(String method, String beside, String topic) {
        if (!method.equals(OwnMethods.NAME)) return method;
        boolean other = !beside.isEmpty() && !beside.equals(OwnMethods.NAME);
        return other ? beside : OwnMethods.right(Topics.named(topic));
    }

    /**
     * Tells by what the user's program refused, or why it was stopped, as a sentence; empty for any
     * other method.
     *
     * @param said in English
     */
    public static Optional<String> refusal(String method, String said, Language language) {
        if (!method.equals(OwnMethods.NAME)) return Optional.empty();
        String words = VerdictDetail.said(language, said);
        return Optional.of(
                words.substring(0, 1).toUpperCase(language.locale()) + words.substring(1));
    }
}
