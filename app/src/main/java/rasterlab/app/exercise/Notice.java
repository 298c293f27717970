package rasterlab.app.exercise;

import java.util.List;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/**
 * Something to tell the user, in words of the window's language only where it is shown.
 *
 * @param key of the text, behind {@code notice.}
 * @param arguments what stands in its places
 */
record Notice(String key, List<String> arguments) {
    static final Notice NONE = new Notice("", List.of());

    Notice {
        arguments = List.copyOf(arguments);
    }

    static Notice of(String key, String... arguments) {
        return new Notice(key, List.of(arguments));
    }

    boolean isEmpty() {
        return key.isEmpty();
    }

    private Object[] said(Language language) {
        return arguments.stream().map(each -> Complaints.said(language, each)).toArray();
    }

    String in(Texts texts) {
        return isEmpty() ? "" : texts.text("notice." + key, said(texts.language()));
    }
}
