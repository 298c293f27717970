package rasterlab.app.language;

import rasterlab.exercises.complaint.ComplaintTexts;

/** Says in the window's language what readers and writers of files say in English. */
public final class Complaints {
    private Complaints() {}

    /** The sentence in that language. */
    public static String translated(Language language, String english) {
        return ComplaintTexts.translated(language.locale(), english);
    }

    /** The sentence on a terminal: numbers keep the point that one types there. */
    public static String saidToTypist(Language language, String english) {
        return ComplaintTexts.saidToTypist(language.locale(), english);
    }

    /** The English sentence in JSON, with powers of ten as programs read them. */
    public static String saidToProgram(String english) {
        return ComplaintTexts.saidToProgram(english);
    }
}
