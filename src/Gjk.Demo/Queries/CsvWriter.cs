namespace Gjk.Demo.Queries;

/// <summary>Writes results as CSV, row by row, through one buffer of fixed size. Floats have enough digits to give the
/// same bits back.</summary>
internal sealed class CsvWriter
{
    /// <summary>The columns of distances, in order.</summary>
    public const string Distances = "a,b,status,overlap,distance,lower_bound,ax,ay,az,bx,by,bz,nx,ny,nz,iterations";

    /// <summary>The columns of casts, in order.</summary>
    public const string Casts = "a,b,status,fraction,px,py,pz,nx,ny,nz,iterations";

    /// <summary>The columns of contact points, in order.</summary>
    public const string Contacts = "a,b,part_a,part_b,point,gap,ax,ay,az,bx,by,bz,nx,ny,nz,feature";

    /// <summary>The columns that follow those of distances with the numbers of the parts.</summary>
    public const string Parts = ",part_a,part_b";

    private const int BufferBytes = 1 << 16;

    /// <summary>The columns that follow the others with the names of the objects.</summary>
    private const string NameColumns = ",a_name,b_name";

    /// <summary>The last column, where answers are checked.</summary>
    private const string CheckColumn = ",check";

    /// <summary>Bytes. More than the longest row without names, which has 13 numbers of at most 16 characters, the
    /// indices and the words.</summary>
    private const int RowBytes = 512;

    private readonly Stream _stream;
    private readonly byte[] _buffer = new byte[BufferBytes];
    private readonly string[]? _names;
    private readonly bool _isChecked;
    private int _used;

    /// <param name="stream">Where to write.</param>
    /// <param name="columns">The columns, <see cref="Distances"/>, <see cref="Casts"/> or
    /// <see cref="Contacts"/>; null for no heading.</param>
    /// <param name="names">The name of each object as a field of CSV, or null for a table without names.</param>
    /// <param name="isChecked">Whether the rows end with a verdict.</param>
    public CsvWriter(Stream stream, string? columns, string[]? names = null, bool isChecked = false)
    {
        _stream = stream;
        _names = names;
        _isChecked = isChecked;
        if (columns is null) return;
        Add(columns + (names is null ? "" : NameColumns) + (isChecked ? CheckColumn : ""));
        EndRow();
    }

    /// <summary>How many rows were written, without the heading.</summary>
    public long Rows { get; private set; }

    /// <summary>How many rows have a refuted answer.</summary>
    public int RefutedRows { get; private set; }

    /// <summary>A row of <see cref="Distances"/>.</summary>
    public void Write(int a, int b, in DistanceResult result, CheckStatus verdict = default)
    {
        AddRow(a, b, result);
        EndRow(a, b, verdict);
    }

    /// <summary>A row of <see cref="Distances"/> and <see cref="Parts"/>.</summary>
    public void Write(int a, int b, in PairDistance result, CheckStatus verdict = default)
    {
        AddRow(a, b, result.Result);
        AddPart(result.PartA);
        AddPart(result.PartB);
        EndRow(a, b, verdict);
    }

    /// <summary>A row of <see cref="Contacts"/>.</summary>
    /// <param name="a">The first object.</param>
    /// <param name="b">The second object.</param>
    /// <param name="contacts">What two parts of them have.</param>
    /// <param name="index">The point among those of the two parts.</param>
    public void Write(int a, int b, in PairContacts contacts, int index)
    {
        if (_used > BufferBytes - RowBytes) Flush();
        ManifoldPoint point = contacts.Manifold[index];
        Add(a);
        Add(b);
        AddPart(contacts.PartA);
        AddPart(contacts.PartB);
        Add(index);
        Add(point.Gap);
        Add(point.PointA);
        Add(point.PointB);
        Add(contacts.Manifold.Normal);
        Add<long>(point.FeatureId, default);
        EndRow(a, b, default);
    }

    private void AddRow(int a, int b, in DistanceResult result)
    {
        if (_used > BufferBytes - RowBytes) Flush();
        Add(a);
        Add(b);
        Add(StatusName(result.Status));
        Add(result.IsOverlapping ? "true" : "false");
        Add(result.Distance);
        Add(result.LowerBound);
        Add(result.PointA);
        Add(result.PointB);
        Add(result.Normal);
        Add(result.Iterations);
    }

    /// <summary>A row of <see cref="Casts"/>. What a status says nothing of is empty.</summary>
    public void Write(int a, int b, in CastResult result, CheckStatus verdict = default)
    {
        if (_used > BufferBytes - RowBytes) Flush();
        Add(a);
        Add(b);
        Add(StatusName(result.Status));
        Add(result.Fraction);
        Add(result.Point);
        Add(result.Normal);
        Add(result.Iterations);
        EndRow(a, b, verdict);
    }

    /// <summary>Writes the buffer to the stream.</summary>
    public void Flush()
    {
        _stream.Write(_buffer, 0, _used);
        _stream.Flush();
        _used = 0;
    }

    /// <summary>The name as <see cref="GjkStatus"/> has it. The switch avoids a metadata search for each row.</summary>
    private static string StatusName(GjkStatus status) => status switch
    {
        GjkStatus.Separated => nameof(GjkStatus.Separated),
        GjkStatus.Overlapping => nameof(GjkStatus.Overlapping),
        GjkStatus.BeyondMaxDistance => nameof(GjkStatus.BeyondMaxDistance),
        GjkStatus.IterationLimit => nameof(GjkStatus.IterationLimit),
        GjkStatus.InvalidInput => nameof(GjkStatus.InvalidInput),
        GjkStatus.InvalidShape => nameof(GjkStatus.InvalidShape),
        _ => throw new ArgumentOutOfRangeException(nameof(status), status, "Unknown status."),
    };

    /// <inheritdoc cref="StatusName(GjkStatus)"/>
    private static string StatusName(CastStatus status) => status switch
    {
        CastStatus.Hit => nameof(CastStatus.Hit),
        CastStatus.Miss => nameof(CastStatus.Miss),
        CastStatus.OverlappingAtStart => nameof(CastStatus.OverlappingAtStart),
        CastStatus.IterationLimit => nameof(CastStatus.IterationLimit),
        CastStatus.InvalidInput => nameof(CastStatus.InvalidInput),
        CastStatus.InvalidShape => nameof(CastStatus.InvalidShape),
        _ => throw new ArgumentOutOfRangeException(nameof(status), status, "Unknown status."),
    };

    /// <summary>A part's number; empty where there is none.</summary>
    private void AddPart(int part)
    {
        if (part >= 0) Add(part);
        else _buffer[_used++] = (byte)',';
    }

    private void Add(Vector3 v)
    {
        Add(v.X);
        Add(v.Y);
        Add(v.Z);
    }

    /// <summary>What is not known is empty. Adding 0 turns -0 into 0.</summary>
    private void Add(float value)
    {
        if (float.IsFinite(value)) Add<float>(value + 0f, "R");
        else _buffer[_used++] = (byte)',';
    }

    private void Add(int value) => Add<int>(value, default);

    private void Add<T>(T value, ReadOnlySpan<char> format)
        where T : IUtf8SpanFormattable
    {
        value.TryFormat(_buffer.AsSpan(_used), out int written, format, CultureInfo.InvariantCulture);
        _used += written;
        _buffer[_used++] = (byte)',';
    }

    private void Add(string text)
    {
        _used += Encoding.ASCII.GetBytes(text, _buffer.AsSpan(_used));
        _buffer[_used++] = (byte)',';
    }

    private static string VerdictName(CheckStatus verdict) => verdict switch
    {
        CheckStatus.Proved => "proved",
        CheckStatus.ProvedAtMost => "proved-at-most",
        CheckStatus.Refuted => "refuted",
        _ => "open",
    };

    private void EndRow(int a, int b, CheckStatus verdict)
    {
        if (_names is not null)
        {
            AddName(_names[a]);
            AddName(_names[b]);
        }

        if (_isChecked) Add(VerdictName(verdict));
        if (verdict == CheckStatus.Refuted) RefutedRows++;
        Rows++;
        EndRow();
    }

    /// <summary>Adds a field of any length. One byte stays free for the comma.</summary>
    private void AddName(string field)
    {
        Encoder encoder = Encoding.UTF8.GetEncoder();
        ReadOnlySpan<char> rest = field;
        for (bool isDone = false; !isDone;)
        {
            if (_used > BufferBytes - RowBytes) Flush();
            Span<byte> room = _buffer.AsSpan(_used, BufferBytes - _used - 1);
            encoder.Convert(rest, room, flush: true, out int read, out int written, out isDone);
            rest = rest[read..];
            _used += written;
        }

        _buffer[_used++] = (byte)',';
    }

    /// <summary>Turns the comma after the last column into the end of the line.</summary>
    private void EndRow() => _buffer[_used - 1] = (byte)'\n';
}
