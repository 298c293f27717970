package rasterlab.engine.light;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.naming.Named;

/** A term of the lighting formula that can be left out to see what it is for. */
public enum LightTerm {
    AMBIENT,
    DIFFUSE,
    SPECULAR,
    EMISSION;

    private static final double[] NONE = new double[3];

    /** Lower-case name, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** All terms: the whole formula. */
    public static Set<LightTerm> all() {
        return EnumSet.allOf(LightTerm.class);
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static LightTerm named(String name) {
        return Named.find("light term", name, List.of(values()), LightTerm::code);
    }

    /** The names that {@link #named} knows. */
    public static List<String> names() {
        return Arrays.stream(values()).map(LightTerm::code).toList();
    }

    /** A material of which only some terms are seen. */
    public static Material only(Set<LightTerm> terms, Material material) {
        SurfaceMaterial whole = material.surface();
        return new Material(
                new SurfaceMaterial(
                        terms.contains(AMBIENT) ? whole.ambient() : NONE,
                        terms.contains(DIFFUSE) ? whole.diffuse() : NONE,
                        terms.contains(SPECULAR) ? whole.specular() : NONE,
                        terms.contains(EMISSION) ? whole.emission() : NONE,
                        whole.shininess()),
                material.alpha());
    }
}
