package rasterlab.engine.geometry.meeting;

import java.util.List;
import rasterlab.contract.LinePlane;
import rasterlab.engine.study.Method;

/** The methods that tell where a line meets a plane, in teaching order. */
final class LinePlaneMethods {

    private LinePlaneMethods() {}

    static List<Method<LinePlane>> all() {
        return List.of(
                Method.failing("formula-textbook", new TextbookMeeting()),
                Method.failing("formula", new CheckedMeeting()),
                Method.right("unrounded", new UnroundedMeeting()));
    }
}
