package rasterlab.app.study;

import java.lang.reflect.Array;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.language.Texts;

/** A hazard's input in words: records by their components, arrays by their elements. */
final class InputText {
    /** Elements of an array or a list that are written out. */
    private static final int MOST = 24;

    private final Texts texts;

    private InputText(Texts texts) {
        this.texts = texts;
    }

    /**
     * @param texts of this package
     */
    static String of(Object value, Texts texts) {
        return new InputText(texts).of(value);
    }

    private String of(Object value) {
        if (value == null) return "–";
        if (value.getClass().isArray()) return array(value);
        if (value instanceof List<?> list) return list(list);
        if (value instanceof Record && !saysItself(value)) return record(value);
        return InputWords.translated(texts, value.toString());
    }

    /** Whether the record has words of its own: those that the compiler gives it are final. */
    private static boolean saysItself(Object value) {
        try {
            int modifiers = value.getClass().getDeclaredMethod("toString").getModifiers();
            return !Modifier.isFinal(modifiers);
        } catch (NoSuchMethodException e) {
            return false;
        }
    }

    private String record(Object value) {
        var parts = new ArrayList<String>();
        for (RecordComponent component : value.getClass().getRecordComponents())
            parts.add(component.getName() + " = " + of(component(value, component)));
        return String.join("\n", parts);
    }

    private static Object component(Object value, RecordComponent component) {
        try {
            var accessor = component.getAccessor();
            accessor.setAccessible(true);
            return accessor.invoke(value);
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new AssertionError("a record's component can be read", e);
        }
    }

    private String array(Object array) {
        var elements = new ArrayList<Object>();
        int length = Array.getLength(array);
        for (int i = 0; i < Math.min(length, MOST); i++) elements.add(Array.get(array, i));
        return joined(elements, length);
    }

    private String list(List<?> list) {
        return joined(list.subList(0, Math.min(list.size(), MOST)), list.size());
    }

    private String joined(List<?> first, int of) {
        var words = new ArrayList<String>();
        for (Object one : first) words.add(of(one).replace("\n", ", "));
        if (of > first.size()) words.add("… (" + of + ")");
        return "[" + String.join(", ", words) + "]";
    }
}
