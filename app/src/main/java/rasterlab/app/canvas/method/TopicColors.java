package rasterlab.app.canvas.method;

import java.awt.Color;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The colours of the methods of a lab's topics; a method of several of them has one colour.
 *
 * @param own of the palette of {@link MethodColors}, by the names of the methods that have one
 */
public record TopicColors(Map<String, Color> own) {
    public TopicColors {
        own = Map.copyOf(own);
    }

    /** The method's own colour; {@link MethodColors#INDIGO} where it has none. */
    public Color of(String method) {
        return own.getOrDefault(method, MethodColors.INDIGO);
    }

    /** Whether the method has a colour of its own. */
    public boolean has(String method) {
        return own.containsKey(method);
    }

    /**
     * Colours to tell the methods of one picture apart: their own, and in the methods' order what
     * is left of the palette, which begins again when it is used up.
     */
    public Map<String, Color> among(List<String> methods) {
        var left = new ArrayList<Color>(MethodColors.PALETTE);
        methods.forEach(method -> left.remove(own.get(method)));
        if (left.isEmpty()) left.addAll(MethodColors.PALETTE);
        var colors = new LinkedHashMap<String, Color>();
        int next = 0;
        for (String method : methods) {
            Color ownColor = own.get(method);
            colors.put(method, ownColor != null ? ownColor : left.get(next++ % left.size()));
        }
        return colors;
    }
}
