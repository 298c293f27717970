package rasterlab.engine.border;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The borders of every topic that has them. */
final class Borders {
    private Borders() {}

    static Stream<Border<?, ?, ?>> all() {
        return Stream.of(
                        RasterBorders.all(),
                        List.of(LinePlaneBorders.all()),
                        PlaneBorders.all(),
                        ClippingBorders.all(),
                        TransformBorders.all(),
                        VisibilityBorders.all(),
                        List.of(OrderBorders.all()),
                        List.of(SurfaceBorders.all()),
                        List.of(CurveBorders.all()),
                        LightBorders.all(),
                        List.of(NormalsBorders.all()),
                        TextureBorders.all())
                .flatMap(List::stream);
    }

    /** Topic name to its border. */
    static Map<String, Border<?, ?, ?>> byTopic() {
        return all().collect(Collectors.toMap(each -> each.topic().name(), Function.identity()));
    }
}
