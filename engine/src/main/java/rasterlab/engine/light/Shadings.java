package rasterlab.engine.light;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.engine.naming.Named;

/** The shadings that can be named. */
public final class Shadings {
    private final Map<String, Shading> byName = new LinkedHashMap<>();

    public Shadings() {
        byName.put("tone", new ToneShading());
        byName.put("flat", FlatShading.lightAtEye(FlatShading.AMBIENT));
    }

    public List<String> names() {
        return List.copyOf(byName.keySet());
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public Shading named(String name) {
        return byName.get(Named.find("shading", name, names(), known -> known));
    }
}
