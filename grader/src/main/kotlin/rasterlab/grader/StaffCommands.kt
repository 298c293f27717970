package rasterlab.grader

import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import rasterlab.grader.course.Name
import rasterlab.grader.course.NewToken
import rasterlab.grader.course.Staff
import rasterlab.grader.course.StaffRole
import rasterlab.grader.storage.text
import java.time.InstantSource
import java.util.concurrent.Callable

/** Works on who teaches, on the server's machine; the server may run meanwhile. */
@Command(
    name = "staff",
    mixinStandardHelpOptions = true,
    description = ["Lists who teaches, adds and renames people, makes their tokens and takes access away."],
)
internal class StaffCommand(
    private val words: CommandWords,
) : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    override fun run(): Unit = throw ParameterException(spec.commandLine(), words.say("command"))
}

/** The staff of the server that is meant. */
internal class StaffOptions {
    @Mixin
    lateinit var of: DataOptions

    fun <T> open(work: (Staff) -> T): T = of.open().use { work(Staff(it, InstantSource.system())) }
}

/** Who of the staff is meant. */
internal class MemberOptions {
    @Mixin
    lateinit var of: StaffOptions

    @Parameters(
        index = "0",
        paramLabel = "ID",
        descriptionKey = "staff.id",
        description = ["The id, as list prints it."],
    )
    lateinit var id: String
}

/** A word for all courses, which is no code of one. */
private const val ALL = "all"

/** The lines are the same in every language, for programs. */
private fun CommandSpec.print(made: NewToken) = commandLine().out.println("staff\t${made.id}\ntoken\t${made.token}")

@Command(
    name = "list",
    mixinStandardHelpOptions = true,
    description = [
        "Prints those who teach and grade, a line for each.",
        "It has id, role, when last here, whether access was taken away, the code of the single course or all, and name.",
    ],
)
internal class StaffListCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: StaffOptions

    override fun call(): Int =
        of.open { staff ->
            for (one in staff.all()) {
                val access = if (one.revokedAt == null) "access" else "revoked"
                val used = one.lastUsedAt?.text() ?: "never"
                val course = one.course?.code ?: ALL
                val told = listOf(one.id, one.role.code, used, access, course, one.name)
                spec.commandLine().out.println(told.joinToString("\t").trim())
            }
            0
        }
}

@Command(
    name = "add",
    mixinStandardHelpOptions = true,
    description = ["Adds an instructor or an assistant, and prints their token, this once."],
)
internal class StaffAddCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: StaffOptions

    @Parameters(paramLabel = "NAME", descriptionKey = "staff.name", description = ["The name."])
    lateinit var name: String

    @Option(
        names = ["--role"],
        paramLabel = "ROLE",
        descriptionKey = "staff.role",
        description = ["instructor or assistant; default: \${DEFAULT-VALUE}."],
    )
    var role = StaffRole.ASSISTANT

    @Option(
        names = ["--course"],
        paramLabel = "COURSE",
        descriptionKey = "staff.only",
        description = ["The id or code of the single course that they teach; without it they teach all."],
    )
    var course: String? = null

    override fun call(): Int =
        of.open { staff ->
            spec.print(staff.add(Name.of(name), role, by = "command", key = null, course))
            0
        }
}

@Command(
    name = "token",
    mixinStandardHelpOptions = true,
    description = ["Makes a new token in the place of the one of before, which stops working; gives access back, too."],
)
internal class StaffTokenCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var member: MemberOptions

    override fun call(): Int =
        member.of.open { staff ->
            spec.print(staff.renew(member.id, by = "command", key = null))
            0
        }
}

@Command(
    name = "rename",
    mixinStandardHelpOptions = true,
    description = ["Gives somebody another name; what they did before stands under it, too."],
)
internal class StaffRenameCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var member: MemberOptions

    @Parameters(index = "1", paramLabel = "NAME", descriptionKey = "staff.name", description = ["The name."])
    lateinit var name: String

    override fun call(): Int =
        member.of.open { staff ->
            val named = staff.rename(member.id, Name.of(name), by = "command")
            spec.commandLine().out.println("name\t${named.name}")
            0
        }
}

@Command(
    name = "course",
    mixinStandardHelpOptions = true,
    description = ["Gives somebody a single course, or all. An instructor of all stays."],
)
internal class StaffCourseCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var member: MemberOptions

    @Parameters(
        index = "1",
        paramLabel = "COURSE",
        descriptionKey = "staff.course",
        description = ["The course's id or code, or all."],
    )
    lateinit var course: String

    override fun call(): Int =
        member.of.open { staff ->
            val given = staff.assign(member.id, course.takeIf { it != ALL }, by = "command")
            spec.commandLine().out.println("course\t${given.course?.code ?: ALL}")
            0
        }
}

@Command(
    name = "revoke",
    mixinStandardHelpOptions = true,
    description = ["Takes somebody's access away. The last instructor stays."],
)
internal class StaffRevokeCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var member: MemberOptions

    override fun call(): Int =
        member.of.open { staff ->
            val gone = staff.revoke(member.id, by = "command")
            spec.commandLine().out.println("revoked\t${gone.id}")
            0
        }
}
