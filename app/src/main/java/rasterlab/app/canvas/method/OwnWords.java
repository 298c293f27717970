package rasterlab.app.canvas.method;

import java.util.Optional;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.Topics;
import rasterlab.exercises.complaint.ComplaintTexts;

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
        String words = VerdictDetail.translated(language, said);
        String sentence =
                ComplaintTexts.isAboutProgram(said)
                        ? words
                        : Texts.of("canvas", language).text("mine.refuses", words);
        return Optional.of(
                sentence.substring(0, 1).toUpperCase(language.locale()) + sentence.substring(1));
    }

    /**
     * Why a method gave no answer, for {@link AboutText}: of the user's program as {@link #refusal}
     * tells it, of any other method in its own words.
     *
     * @param said in English
     */
    public static String reason(String method, String said, Language language) {
        return refusal(method, said, language)
                .orElseGet(() -> VerdictDetail.translated(language, said));
    }

    /**
     * The words in place of a number that a method did not find: the user's program may have been
     * stopped instead of refusing.
     *
     * @param refused the word for a method that refused
     */
    public static String without(String method, String refused, Language language) {
        return method.equals(OwnMethods.NAME)
                ? Texts.of("canvas", language).text("mine.none")
                : refused;
    }
}
