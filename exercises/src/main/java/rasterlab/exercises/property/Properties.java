package rasterlab.exercises.property;

import java.util.List;
import java.util.stream.Stream;

/** The properties that an exercise may name. */
public final class Properties {
    private static final List<Property<?, ?>> ALL =
            Stream.<List<? extends Property<?, ?>>>of(
                            LineProperties.ALL,
                            PixelProperties.ALL,
                            ClipProperties.ALL,
                            AreaProperties.ALL,
                            MotionProperties.ALL,
                            DepthProperties.ALL,
                            CurveProperties.ALL,
                            SplineProperties.ALL,
                            LightProperties.ALL,
                            ColorProperties.ALL)
                    .<Property<?, ?>>flatMap(List::stream)
                    .toList();

    private Properties() {}

    /** All, those of one topic one after the other. */
    public static List<Property<?, ?>> all() {
        return ALL;
    }

    /** The properties of a topic. */
    public static List<Property<?, ?>> of(String topic) {
        return ALL.stream().filter(one -> one.topic().equals(topic)).toList();
    }
}
