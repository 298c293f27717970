package rasterlab.app.language;

import java.awt.event.KeyEvent;
import java.text.MessageFormat;
import java.util.Locale;
import java.util.MissingResourceException;
import java.util.ResourceBundle;
import java.util.Set;
import rasterlab.exercises.words.PluralForms;
import rasterlab.exercises.words.TopicWords;

/**
 * The texts of one package of the app in one language.
 *
 * <p>A text with arguments is a {@link MessageFormat} pattern; one without is taken as it stands,
 * so that an apostrophe needs doubling in patterns only. Words take the form that goes with a
 * number by {@code {0,plural,one#…|other#…}}, in Russian {@code one}, {@code few} and {@code many}.
 */
public final class Texts {
    private final ResourceBundle bundle;
    private final Language language;

    private Texts(ResourceBundle bundle, Language language) {
        this.bundle = bundle;
        this.language = language;
    }

    /**
     * @param feature last word of the package, such as {@code line}
     * @throws MissingResourceException when that package has no texts
     */
    public static Texts of(String feature, Language language) {
        return of(feature, "messages", language);
    }

    /**
     * @param bundle the name of the package's file, such as {@code messages}
     * @throws MissingResourceException when that package has no such texts
     */
    public static Texts of(String feature, String bundle, Language language) {
        return new Texts(bundle(feature, bundle, language), language);
    }

    /** The words about a topic, which its lab, studies and the command line share. */
    public static Texts ofTopic(String topic, Language language) {
        return new Texts(TopicWords.of(topic, language.locale()), language);
    }

    /** The texts for a library that looks up its own keys. */
    public static ResourceBundle bundle(String feature, String bundle, Language language) {
        return bundle("rasterlab.app." + feature + "." + bundle, language);
    }

    /** The texts of any package, by the bundle's whole name. */
    public static ResourceBundle bundle(String name, Language language) {
        var onlyAsked =
                ResourceBundle.Control.getNoFallbackControl(
                        ResourceBundle.Control.FORMAT_PROPERTIES);
        return ResourceBundle.getBundle(name, language.locale(), onlyAsked);
    }

    public Language language() {
        return language;
    }

    public Locale locale() {
        return language.locale();
    }

    /** All keys, in no order. */
    public Set<String> keys() {
        return bundle.keySet();
    }

    public boolean has(String key) {
        return bundle.containsKey(key);
    }

    /**
     * @throws MissingResourceException naming the key when there is no such text
     */
    public String text(String key, Object... arguments) {
        String pattern = bundle.getString(key);
        return arguments.length == 0
                ? pattern
                : new MessageFormat(PluralForms.chosen(pattern, arguments, locale()), locale())
                        .format(arguments);
    }

    /**
     * A noun in the form that goes with the number: {@code KEY.one}, {@code KEY.few}, {@code
     * KEY.many}, {@code KEY.other}.
     *
     * @see Language#plural
     */
    public String plural(String key, double number) {
        return text(key + "." + language.plural(number));
    }

    /** The text, or {@code otherwise} where there is none, for names that others may add. */
    public String textOr(String key, String otherwise) {
        return has(key) ? text(key) : otherwise;
    }

    /**
     * The text without the {@code &} that marks its mnemonic.
     *
     * @see #mnemonic
     */
    public String label(String key) {
        return text(key).replace("&", "");
    }

    /** Where in {@link #label} the letter of the mnemonic stands; −1 where there is none. */
    public int mnemonicIndex(String key) {
        return text(key).indexOf('&');
    }

    /**
     * The key to press with Alt, that of the letter behind {@code &}; 0 where there is none.
     *
     * @return a key code of {@link KeyEvent}, which for letters beyond a–z is an extended one
     */
    public int mnemonic(String key) {
        int mark = mnemonicIndex(key);
        return mark < 0 ? 0 : KeyEvent.getExtendedKeyCodeForChar(text(key).charAt(mark + 1));
    }
}
